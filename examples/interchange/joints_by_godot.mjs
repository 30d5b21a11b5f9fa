#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Imports FOLDER/clips.glb by Godot 3 with the .import file of godot/, and prints where it has the
// joints at the samples of FOLDER/joints.json: usage: joints_by_godot.mjs FOLDER. Exits with 77, a
// skipped test, where there is no godot3-server.
import { spawn, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";

const folder = process.argv[2];
const project = mkdtempSync(`${tmpdir()}/flinch-godot-`);
const options = { encoding: "utf8", maxBuffer: 1e8, env: { ...process.env, HOME: project } };

/** Lets the editor import what the project holds; it then goes on, in spite of --quit. */
async function importAll() {
  const editor = spawn("godot3-server", ["--path", project, "--editor", "--quit"], { ...options, stdio: "ignore" });
  const isDone = () => existsSync(`${project}/.import`) && readdirSync(`${project}/.import`).some((name) => name.endsWith(".md5"));
  const failed = new Promise((_, reject) => editor.on("error", reject));
  while (!isDone()) await Promise.race([failed, new Promise((done) => setTimeout(done, 200))]);
  editor.kill("SIGKILL");
}

if (spawnSync("godot3-server", ["--version"]).error) {
  console.log("skipped: there is no godot3-server; apt-get install godot3-server installs it");
  process.exit(77);
}
try {
  cpSync(new URL("godot", import.meta.url), project, { recursive: true });
  for (const name of ["clips.glb", "joints.json"]) cpSync(`${folder}/${name}`, `${project}/${name}`);
  await importAll();
  const { stdout } = spawnSync("godot3-server", ["--path", project, "--script", "joints.gd"], options);
  const line = stdout.split("\n").find((text) => text.startsWith("joints: "));
  if (!line) throw new Error(`Godot printed no joints:\n${stdout}`);
  console.log(line.slice("joints: ".length));
} finally {
  rmSync(project, { recursive: true });
}
