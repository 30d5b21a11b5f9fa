// SPDX-License-Identifier: MIT
import { AnimationMixer, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

/** Where three.js has every node: an object of names and world positions for each sample. */
export async function joints(file, samples) {
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes, "");
  const mixer = new AnimationMixer(scene);
  return samples.map(({ animation, time_s }) => {
    const clip = animations.find(({ name }) => name === animation);
    mixer.stopAllAction();
    mixer.clipAction(clip).play();
    // At the very end a repeated clip would be at its beginning.
    mixer.setTime(Math.min(time_s, clip.duration - 1e-6));
    scene.updateMatrixWorld(true);
    const found = {};
    scene.traverse((node) => {
      found[node.name] = node.getWorldPosition(new Vector3()).toArray();
    });
    return found;
  });
}
