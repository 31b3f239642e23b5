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
new MutationObserver(() => {
  document.querySelectorAll(".q-loading-bar:not([aria-label])").forEach((bar) => bar.setAttribute("aria-label", "Loading"));
  document.querySelectorAll(".q-table__middle:not([tabindex])").forEach((box) => box.setAttribute("tabindex", "0"));
  babbitt.settle();
}).observe(document.documentElement, {childList: true, subtree: true});
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
