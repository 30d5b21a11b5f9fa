// SPDX-License-Identifier: MIT
// Dragging: on the figure it aims, as with a sling pulled back towards where the ball comes from;
// beside it, it turns the view.
import { Vector3 } from "three";
import type { View } from "./link";
import type { Stage } from "./stage";
import { allowed, kGravity, threatOf, type Throw } from "./throw";

const kTurn = 0.4; // degrees per pixel
const kRise = 0.006; // m per pixel
const kPathPoints = 40;

export interface AimHandlers {
  view: () => View;
  canAim: () => boolean; // otherwise every drag turns the view
  turned: (camera: View["camera"]) => void;
  aimed: (one: Throw) => void; // while dragging
  thrown: (one: Throw) => void;
}

export function connectAim(stage: Stage, handlers: AimHandlers): void {
  const { canvas } = stage;
  let drag: { x: number; y: number; aim: Vector3 | null; begin: View } | null = null;
  let pinch = 0; // distance of two fingers
  const fingers = new Map<number, PointerEvent>();

  const aimedThrow = (event: PointerEvent): Throw => {
    const { x, y, aim, begin } = drag!;
    const { camera, thrown } = begin;
    // Sideways turns the ball's origin about the figure, starting from the side of the viewer.
    const sideways = (event.clientX - x) * kTurn;
    const azimuth = ((camera[0] + sideways + 540) % 360) - 180;
    const from_height = 1.4 - (event.clientY - y) * kRise;
    return allowed({ ...thrown, aim: aim!.toArray() as Throw["aim"], azimuth, from_height });
  };

  canvas.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
    const box = canvas.getBoundingClientRect();
    const at = [event.clientX - box.left, event.clientY - box.top] as const;
    const aim = handlers.canAim() ? stage.pick(...at) : null;
    drag = { x: event.clientX, y: event.clientY, aim, begin: structuredClone(handlers.view()) };
    canvas.classList.toggle("aims", aim !== null);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    fingers.set(event.pointerId, event);
    if (fingers.size === 2) {
      const [a, b] = [...fingers.values()] as [PointerEvent, PointerEvent];
      const distance = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      if (pinch > 0) zoom(pinch / distance);
      pinch = distance;
      drag.aim = null;
      return;
    }
    if (drag.aim) {
      const one = aimedThrow(event);
      handlers.aimed(one);
      stage.showAim(pathOf(one));
      return;
    }
    const [azimuth, elevation, distance] = drag.begin.camera;
    const rise = elevation + (event.clientY - drag.y) * kTurn;
    handlers.turned([
      azimuth - (event.clientX - drag.x) * kTurn,
      Math.min(Math.max(rise, -5), 89),
      distance,
    ]);
  });
  const end = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    pinch = 0;
    if (drag?.aim && event.type === "pointerup") handlers.thrown(aimedThrow(event));
    stage.showAim([]);
    canvas.classList.remove("aims");
    drag = null;
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      zoom(Math.exp(event.deltaY * 0.001));
    },
    { passive: false },
  );

  function zoom(factor: number) {
    const [azimuth, elevation, distance] = handlers.view().camera;
    handlers.turned([azimuth, elevation, Math.min(Math.max(distance * factor, 1), 15)]);
  }
}

/** The free flight of a throw up to its impact. */
function pathOf(one: Throw): Vector3[] {
  const { position, velocity } = threatOf(one);
  return Array.from({ length: kPathPoints + 1 }, (_, i) => {
    const t = (one.time * i) / kPathPoints;
    return new Vector3(
      position[0]! + velocity[0]! * t,
      position[1]! + velocity[1]! * t,
      position[2]! + velocity[2]! * t - (kGravity * t * t) / 2,
    );
  });
}
