// SPDX-License-Identifier: MIT
// glTF-Transform edits files and plays nothing: the values between keys are found here, after
// appendix C of the glTF 2.0 specification.
import { WebIO } from "@gltf-transform/core";

/** Where glTF-Transform has every node: an object of names and world positions for each sample. */
export async function joints(file, samples) {
  const root = (await new WebIO().readBinary(file)).getRoot();
  return samples.map(({ animation, time_s }) => {
    const one = root.listAnimations().find((candidate) => candidate.getName() === animation);
    for (const channel of one.listChannels()) {
      const value = valueAt(channel.getSampler(), time_s);
      const node = channel.getTargetNode();
      if (channel.getTargetPath() === "rotation") node.setRotation(value);
      else node.setTranslation(value);
    }
    return Object.fromEntries(
      root.listNodes().map((node) => [node.getName(), node.getWorldTranslation()]),
    );
  });
}

function valueAt(sampler, time) {
  const times = sampler.getInput().getArray();
  const key = (index) => sampler.getOutput().getElement(index, []);
  const next = times.findIndex((other) => other > time);
  if (next <= 0) return key(next === 0 ? 0 : times.length - 1);
  const share = (time - times[next - 1]) / (times[next] - times[next - 1]);
  const [a, b] = [key(next - 1), key(next)];
  const [from, to] = a.length === 4 ? weightsOfSlerp(a, b, share) : [1 - share, share];
  return a.map((value, i) => from * value + to * b[i]);
}

function weightsOfSlerp(a, b, share) {
  const cosine = a.reduce((sum, value, i) => sum + value * b[i], 0);
  const angle = Math.acos(Math.min(Math.abs(cosine), 1));
  if (angle < 1e-4) return [1 - share, share];
  const sign = cosine < 0 ? -1 : 1;
  return [Math.sin((1 - share) * angle) / Math.sin(angle), (sign * Math.sin(share * angle)) / Math.sin(angle)];
}
