// SPDX-License-Identifier: MIT
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { FreeCamera } from "@babylonjs/core/Cameras/freeCamera.js";
import { SceneLoader } from "@babylonjs/core/Loading/sceneLoader.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { Scene } from "@babylonjs/core/scene.js";
import "@babylonjs/core/Animations/animatable.js";
import "@babylonjs/loaders/glTF/2.0/index.js";

/** Where Babylon.js has every node: an object of names and world positions for each sample. */
export async function joints(file, samples) {
  const scene = new Scene(new NullEngine());
  scene.useRightHandedSystem = true; // otherwise it mirrors files like ours at a root node
  new FreeCamera("camera", Vector3.Zero(), scene);
  const data = `data:base64,${Buffer.from(file).toString("base64")}`;
  const { animationGroups, transformNodes } = await SceneLoader.ImportMeshAsync("", "", data, scene, null, ".glb");
  for (const group of animationGroups) group.stop();
  return samples.map(({ animation, time_s }) => {
    const group = animationGroups.find(({ name }) => name === animation);
    group.start(false);
    group.goToFrame(time_s * 60); // its frames, whatever the file's rate
    const found = {};
    for (const node of transformNodes) {
      node.computeWorldMatrix(true);
      found[node.name] = node.getAbsolutePosition().asArray();
    }
    group.stop();
    return found;
  });
}
