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
