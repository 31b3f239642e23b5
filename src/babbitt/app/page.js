window.babbitt = {
  still: matchMedia("(prefers-reduced-motion: reduce)").matches,
  // Orbits move, or are held.
  settle: () => document.querySelectorAll("svg.picture").forEach(
    (drawn) => babbitt.still ? drawn.pauseAnimations() : drawn.unpauseAnimations()),
  hold: () => { babbitt.still = !babbitt.still; babbitt.settle(); },
  // The draft outlives a reload: it is kept by the browser, for this tab alone, and is sent to nobody else.
  // An address with an earlier case would send that to whoever gets it: it goes with the first change.
  keep: (key, link, draft) => {
    if (location.hash && location.hash !== link) history.replaceState(null, "", location.pathname + location.search);
    try { sessionStorage.setItem(key, JSON.stringify({hash: location.hash, ...draft})); } catch { /* full, or forbidden */ }
  },
  kept: (key) => {
    try {
      const found = JSON.parse(sessionStorage.getItem(key));
      return found && found.hash === location.hash ? found : {};
    } catch { return {}; }
  },
  // Another language is the same page asked for anew: the address says which.
  speak: (language) => {
    const address = new URL(location.href);
    address.searchParams.set("language", language);
    location.href = address.href;
  },
};
// What the library of the page leaves without a name, or out of reach of the keyboard.
(() => {
  const set = (part, name, value) => {
    if (value === null) part.removeAttribute(name);
    else if (part.getAttribute(name) !== value) part.setAttribute(name, value);
  };
  // Role, name and value of a slider stand on what takes the keys, not on what is around it.
  const slide = (slider) => {
    const taken = slider.querySelector(".q-slider__track-container");
    for (const name of ["role", "aria-label", "aria-orientation", "aria-valuemin", "aria-valuemax", "aria-valuenow"]) {
      if (!slider.hasAttribute(name)) continue;
      set(taken, name, slider.getAttribute(name));
      slider.removeAttribute(name);
    }
    set(taken, "aria-valuetext", slider.parentElement.querySelector(".number")?.textContent ?? null);
  };
  // A field says whether it is wrong, and what stands under it.
  const tell = (field) => {
    const control = field.querySelector("input, textarea"), said = field.querySelector(".q-field__messages");
    if (!control) return;
    if (said?.textContent) said.id ||= `${control.id}-said`;
    set(control, "aria-invalid", field.classList.contains("q-field--error") ? "true" : null);
    set(control, "aria-describedby", said?.textContent ? said.id : null);
  };
  // The text of the case has its name where it is typed.
  const name = (typed) => {
    set(typed, "aria-label", typed.closest("[aria-label]").getAttribute("aria-label"));
    set(typed, "tabindex", "0");
  };
  const all = (those, act) => document.querySelectorAll(those).forEach(act);
  new MutationObserver(() => {
    all(".q-loading-bar:not([aria-label])", (bar) => set(bar, "aria-label", "Loading"));
    all(".q-table__middle:not([tabindex])", (box) => set(box, "tabindex", "0"));
    all(".q-slider", slide);
    all(".q-field", tell);
    all(".editor .cm-content:not([tabindex])", name);
    babbitt.settle();
  }).observe(document.documentElement,
    {childList: true, subtree: true, attributes: true, attributeFilter: ["class", "aria-valuenow"]});
})();
// A control that is drawn anew, or may be pressed again, has the focus that the one before it had.
(() => {
  const CONTROLS = "button, a, input, textarea, [role=tab], [role=switch], [role=slider], [role=button]";
  let last = null;
  const nameOf = (control) => control.getAttribute("aria-label")
    || control.closest("label")?.querySelector("[aria-label]")?.getAttribute("aria-label") || control.textContent;
  const like = (control) => `${control.getAttribute("role") ?? control.tagName} ${nameOf(control)}`;
  const alike = (area, wanted) => [...area.querySelectorAll(CONTROLS)].filter((one) => like(one) === wanted);
  // A button that has hidden itself, as Cancel does, leaves the focus to the control before it.
  const before = (control) => {
    const controls = [...last.area.querySelectorAll(CONTROLS)];
    return controls.slice(0, controls.indexOf(control)).findLast((one) => one.checkVisibility());
  };
  document.addEventListener("focusin", (event) => {
    const area = event.target.closest("header, section");
    if (!area) return;
    // Of a field its own control: a word of it that was taken away does not come back.
    const control = event.target.closest(".q-field")?.querySelector("input, textarea") ?? event.target;
    const wanted = like(control);
    last = {control, area, wanted, place: alike(area, wanted).indexOf(control)};
  });
  // Whoever points elsewhere has left; what hangs under a control is a part of it.
  document.addEventListener("pointerdown", (event) => {
    const whole = last?.control.closest(".q-field") ?? last?.control;
    if (!event.target.closest(".q-menu") && !whole?.contains(event.target)) last = null;
  }, true);
  new MutationObserver(() => {
    if (!last || document.activeElement !== document.body) return;
    const found = alike(last.area, last.wanted);
    let control = last.control.isConnected ? last.control : found[Math.min(last.place, found.length - 1)];
    if (control && !control.checkVisibility()) control = before(control);
    if (control && !control.disabled) control.focus({preventScroll: true});
  }).observe(document.documentElement,
    {childList: true, subtree: true, attributes: true, attributeFilter: ["disabled"]});
})();
// Tab leaves the text of the case, as it leaves every field.
document.addEventListener("keydown", (event) => {
  if (event.key === "Tab" && event.target.closest?.(".cm-editor")) event.stopPropagation();
}, true);
// Skip to a part of the page: its address stays that of the case.
document.addEventListener("click", (event) => {
  const link = event.target.closest?.("a.skip");
  if (!link) return;
  event.preventDefault();
  document.querySelector(link.getAttribute("href")).focus();
});
// What a field or button is for shows to keys as it does to the mouse.
["focusin", "focusout"].forEach((kind) => document.addEventListener(kind, (event) => {
  if (kind === "focusin" && !event.target.matches(":focus-visible")) return;
  const whole = event.target.closest(".q-field, .q-btn");
  for (let part = event.target; whole?.contains(part); part = part.parentElement) {
    part.dispatchEvent(new MouseEvent(kind === "focusin" ? "mouseenter" : "mouseleave"));
  }
}));
// Arrow keys go through a menu, as its role promises.
document.addEventListener("keydown", (event) => {
  const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
  const menu = document.querySelector(".q-menu:has([role=menuitem])");
  if (!step || !menu?.contains(document.activeElement)) return;
  const entries = [...menu.querySelectorAll("[role=menuitem]")];
  const at = entries.indexOf(document.activeElement);
  entries[(at < 0 && step < 0 ? entries.length - 1 : at + step + entries.length) % entries.length].focus();
  event.preventDefault();
});
// Drag what may be turned: the load arrow, grooves, pockets and holes.
(() => {
  let held = null;
  const angleAt = (frame, event) => {
    const origin = frame.getScreenCTM();
    return Math.atan2(origin.f - event.clientY, event.clientX - origin.e) * 180 / Math.PI;
  };
  document.addEventListener("pointerdown", (event) => {
    const shape = event.target.closest?.("svg.picture .handle");
    if (!shape) return;
    const frame = shape.parentNode;
    held = {field: shape.dataset.field, from: angleAt(frame, event), angle: Number(shape.dataset.angle), frame,
      shapes: frame.querySelectorAll(`[data-field="${shape.dataset.field}"]`), turn: 0};
    event.preventDefault();
  });
  document.addEventListener("pointermove", (event) => {
    if (!held) return;
    held.turn = angleAt(held.frame, event) - held.from;
    held.shapes.forEach((shape) => shape.setAttribute("transform", `rotate(${-held.turn})`));
  });
  document.addEventListener("pointerup", () => {
    if (!held) return;
    const angle = ((held.angle + held.turn + 540) % 360) - 180;
    if (held.turn !== 0) emitEvent("turned", {field: held.field, angle: angle});
    held = null;
  });
})();
window.addEventListener("hashchange", () => emitEvent("linked", location.hash));
