#!/usr/bin/env python3
"""Lumenshop beside its peers on one mesh, in turns, so that a busy machine is busy for both.

Prints the ratio to VTK of a frame, and the ratios to `f3d --output` of a whole process's time and peak memory.
Needs packages of the groups build, test and bench (packages.txt) and the target vtk-peer.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="?", help="a mesh file (default: the phantom, about a million triangles)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--size", default="1280x1024")
    parser.add_argument("--frames", type=int, default=30)
    parser.add_argument("--turns", type=int, default=5, help="how often each program runs")
    parser.add_argument("--triangles", type=int, default=1_000_000, help="of the phantom")
    parser.add_argument("--ssao", action="store_true", help="with screen-space ambient occlusion of 32 samples")
    parser.add_argument("--transparent", action="store_true", help="everything at opacity .4: weighted sums, and exact against VTK's 8 dual peels")
    return parser.parse_args()


def output_of(command, environment=None):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, env=environment).stdout


def measure_process(command, environment=None):
    """Seconds and peak bytes of the largest process of a command."""
    with open(os.devnull, "wb") as nowhere:
        begin = time.perf_counter()
        process = subprocess.Popen([str(word) for word in command], stdout=nowhere, stderr=subprocess.PIPE, env=environment)
        message = process.stderr.read().decode()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{command[0]} failed: {message.strip()}")
    return seconds, usage.ru_maxrss * 1024


class Display:
    """An X server of our own: neither VTK nor f3d draws without one."""

    def __enter__(self):
        reader, writer = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1200x24"], pass_fds=[writer],
                                       stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as numbers:
            self.environment = dict(os.environ, DISPLAY=":" + numbers.readline().strip())
        return self.environment

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def session_of(mesh, folder, ssao, camera):
    """What VTK draws, too: Lambert and Phong, two directional lights, one sample per pixel, its camera."""
    session = {
        "lumenshop": 1,
        "plugins": {
            "data": {"type": "importer.vtk", "path": str(mesh)},
            "ambient": {"type": "ambient.constant"},
            "lambert": {"type": "diffuse.lambert"},
            "phong": {"type": "specular.phong"},
            "surface": {"type": "renderer.surface", "mesh": {"link": "data.mesh"}, "ambient": "ambient", "diffuse": "lambert", "specular": "phong",
                        "diffuse_color": [0.72, 0.04, 0.05], "specular_color": [0.3, 0.3, 0.3], "shininess": 40},
            "camera": {"type": "interactor.orbit", "pivot": camera["pivot"], "distance": camera["distance"], "field_of_view": 30},
            "front": {"type": "interactor.light", "direction": [0.3, -1, 0.4]},
            "back": {"type": "interactor.light", "direction": [-0.3, 1, -0.2], "intensity": 0.4},
        },
        "views": {"main": {"camera": "camera", "lights": ["front", "back"], "renderers": ["surface"], "antialiasing": 1}},
    }
    if ssao:
        session["plugins"]["ssao"] = {"type": "occlusion.ssao", "samples": 32}
        session["views"]["main"]["occlusion"] = "ssao"
    file = folder / "scene.json"
    file.write_text(json.dumps(session, indent=2))
    return file


def phantom(program, folder, triangles):
    session = folder / "phantom.json"
    session.write_text(json.dumps({"lumenshop": 1, "plugins": {"phantom": {"type": "importer.phantom", "triangles": triangles}}, "views": {}}))
    mesh = folder / "phantom.vtp"
    output_of([program, "export", session, "phantom.mesh", "-o", mesh])
    return mesh


def compare_transparency(arguments, program, vtk, scene, display):
    """Frames of transparent surfaces, by weighted sums and exactly."""
    session = json.loads(scene.read_text())
    session["plugins"]["opacity"] = {"type": "opacity.constant", "alpha": 0.4}
    session["plugins"]["surface"]["opacity"] = "opacity"
    scenes = {}
    for case, technique in {"weighted": "weighted", "exact": "linked_list"}.items():
        session["plugins"]["technique"] = {"type": "transparency." + technique}
        session["views"]["main"]["transparency"] = "technique"
        scenes[case] = scene.with_name(case + ".json")
        scenes[case].write_text(json.dumps(session))
    frames = {(who, case): [] for who in ("ours", "theirs") for case in scenes}
    for _ in range(arguments.turns):
        for case, file in scenes.items():
            ours = output_of([program, "bench", file, "--size", arguments.size, "--frames", arguments.frames, "--json"])
            theirs = output_of(vtk + [arguments.frames, "--transparent", case], display)
            frames["ours", case].append(json.loads(ours)["frame"]["median_ms"])
            frames["theirs", case].append(json.loads(theirs)["frame"]["median_ms"])
    for case in scenes:
        frame, frame_vtk = (statistics.median(frames[who, case]) for who in ("ours", "theirs"))
        turns = sorted(ours / theirs for ours, theirs in zip(frames["ours", case], frames["theirs", case]))
        print(f"{case:12} {frame:8.1f} ms   VTK {frame_vtk:8.1f} ms   ratio {statistics.median(turns):.2f} ({turns[0]:.2f} to {turns[-1]:.2f} by turn)")


def main():
    arguments = parse_arguments()
    width, height = arguments.size.split("x")
    program, peer = arguments.build / "bin/lumenshop", arguments.build / "bin/vtk-peer"
    with tempfile.TemporaryDirectory() as name, Display() as display:
        folder = pathlib.Path(name)
        mesh = pathlib.Path(arguments.mesh).resolve() if arguments.mesh else phantom(program, folder, arguments.triangles)
        vtk = [peer, mesh, width, height]
        camera = json.loads(output_of(vtk + [1], display))
        scene = session_of(mesh, folder, arguments.ssao, camera)

        if arguments.transparent:
            compare_transparency(arguments, program, vtk, scene, display)
            return

        ours, theirs = [], []
        for _ in range(arguments.turns):
            ours.append(json.loads(output_of([program, "bench", scene, "--size", arguments.size, "--frames", arguments.frames, "--json"])))
            theirs.append(json.loads(output_of(vtk + [arguments.frames] + ["--ssao"] * arguments.ssao, display)))
        frame = statistics.median(run["frame"]["median_ms"] for run in ours)
        frame_vtk = statistics.median(run["frame"]["median_ms"] for run in theirs)
        print(f"{mesh.name}, {theirs[0]['triangles']:,} triangles, {arguments.size}, medians of {arguments.turns} runs in turns")
        print(f"frame        {frame:8.1f} ms   VTK {frame_vtk:8.1f} ms   ratio {frame / frame_vtk:.2f}")
        host = [run["host_cpu"]["median_ms"] for run in ours if "host_cpu" in run]
        if host:
            print(f"host CPU     {statistics.median(host):8.3f} ms   per frame, GL work aside")

        ours, theirs = [], []
        for _ in range(arguments.turns):
            ours.append(measure_process([program, "render", mesh, "-o", folder / "ours.png", "--size", arguments.size]))
            theirs.append(measure_process(["f3d", mesh, "--output", folder / "theirs.png", f"--resolution={width},{height}"], display))
        seconds, seconds_f3d = (statistics.median(run[0] for run in runs) for runs in (ours, theirs))
        memory, memory_f3d = (statistics.median(run[1] for run in runs) for runs in (ours, theirs))
        print(f"whole render {seconds:8.2f} s    f3d {seconds_f3d:8.2f} s    ratio {seconds / seconds_f3d:.2f}")
        print(f"peak memory  {memory / 1e6:8.0f} MB   f3d {memory_f3d / 1e6:8.0f} MB   ratio {memory / memory_f3d:.2f}")


if __name__ == "__main__":
    main()
