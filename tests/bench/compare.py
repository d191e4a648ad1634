#!/usr/bin/env python3
"""Lumenshop beside its peers on one mesh, in turns, so that a busy machine is busy for both.

Prints the ratio to VTK of a frame, and the ratios to `f3d --output` of a whole process: its time, with driver caches warm and cold, the
peak memory of its largest process, and the peak of all its processes together, shared pages by their share (PSS).
Needs packages of the groups build, test and bench (packages.txt) and the target vtk-peer; leaves out what is not there.
"""
import argparse
import json
import os
import pathlib
import shutil
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
    parser.add_argument("--turns", type=int, default=7, help="how often each program runs")
    parser.add_argument("--triangles", type=int, default=1_000_000, help="of the phantom")
    parser.add_argument("--ssao", type=int, nargs="?", const=64, default=0, metavar="SAMPLES",
                        help="with screen-space ambient occlusion, blurred, of so many samples (alone: 64)")
    parser.add_argument("--frame-only", action="store_true", help="leave out whole processes, and f3d")
    parser.add_argument("--split", action="store_true", help="a split frame against the whole one, by look of the inside; no peer")
    parser.add_argument("--center", type=float, nargs=3, default=[0, 0, 0], help="a point of the cutting plane (default: in the phantom's middle)")
    parser.add_argument("--offset", type=float, default=20, help="how far each half moves, world units")
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


def descendants(process):
    """The process and all below it."""
    found = [process]
    try:
        for thread in os.listdir(f"/proc/{process}/task"):
            with open(f"/proc/{process}/task/{thread}/children") as children:
                for child in children.read().split():
                    found += descendants(child)
    except OSError:
        pass  # it ended meanwhile
    return found


def proportional_bytes(process):
    try:
        with open(f"/proc/{process}/smaps_rollup") as rollup:
            return 1024 * next(int(line.split()[1]) for line in rollup if line.startswith("Pss:"))
    except (OSError, StopIteration):
        return 0


def peak_of_all(command, environment=None):
    """Peak bytes of a command's processes together. Looking slows the command down: not for timing."""
    with open(os.devnull, "wb") as nowhere, subprocess.Popen([str(word) for word in command], stdout=nowhere, stderr=nowhere, env=environment) as process:
        peak = 0
        while process.poll() is None:
            peak = max(peak, sum(proportional_bytes(each) for each in descendants(process.pid)))
            time.sleep(0.005)
    return peak


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
        session["plugins"]["ssao"] = {"type": "occlusion.ssao", "samples": ssao}
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


def compare_splits(arguments, folder, mesh, program):
    """Frames of a surface cut through its middle, halves a tenth of its size apart, against the whole surface."""
    looks = ["none", "lit", "cut_surface", "cap"]
    scenes = {}
    for look in ["whole"] + looks:
        session = {
            "lumenshop": 1,
            "plugins": {
                "data": {"type": "importer.vtk", "path": str(mesh)},
                "lambert": {"type": "diffuse.lambert"}, "phong": {"type": "specular.phong"},
                "surface": {"type": "renderer.surface", "mesh": {"link": "data.mesh"}, "diffuse": "lambert", "specular": "phong"},
                "camera": {"type": "interactor.orbit"}, "front": {"type": "interactor.light", "direction": [0.3, -1, 0.4]},
            },
            "views": {"main": {"camera": "camera", "lights": ["front"], "renderers": ["surface"], "antialiasing": 1}},
        }
        if look != "whole":
            session["plugins"]["cut"] = {"type": "splitter.plane", "translation": arguments.center, "axis": [1, 0, 0], "angle": 60,
                                         "offset": arguments.offset, "interior": look}
            session["plugins"]["surface"]["splitter"] = ["cut"]
        scenes[look] = folder / (look + ".json")
        scenes[look].write_text(json.dumps(session))
    frames = {look: [] for look in scenes}
    for _ in range(arguments.turns):
        for look, file in scenes.items():
            run = json.loads(output_of([program, "bench", file, "--size", arguments.size, "--frames", arguments.frames, "--json"]))
            frames[look].append(run["frame"]["median_ms"])
    print(f"{mesh.name}, {arguments.size}, medians of {arguments.turns} runs in turns")
    for look in scenes:
        turns = sorted(split / whole for split, whole in zip(frames[look], frames["whole"]))
        print(f"{look:12} {statistics.median(frames[look]):8.1f} ms   ratio {statistics.median(turns):.2f} ({turns[0]:.2f} to {turns[-1]:.2f} by turn)")


def compare_frames(arguments, folder, mesh, program, display):
    width, height = arguments.size.split("x")
    peer = arguments.build / "bin/vtk-peer"
    if not peer.exists():
        print(f"frame: {peer} is not there; build the target vtk-peer")
        return
    vtk = [peer, mesh, width, height]
    camera = json.loads(output_of(vtk + [1], display))
    scene = session_of(mesh, folder, arguments.ssao, camera)
    if arguments.transparent:
        compare_transparency(arguments, program, vtk, scene, display)
        return
    ours, theirs = [], []
    for _ in range(arguments.turns):
        ours.append(json.loads(output_of([program, "bench", scene, "--size", arguments.size, "--frames", arguments.frames, "--json"])))
        theirs.append(json.loads(output_of(vtk + [arguments.frames] + (["--ssao", arguments.ssao] if arguments.ssao else []), display)))
    frame = statistics.median(run["frame"]["median_ms"] for run in ours)
    frame_vtk = statistics.median(run["frame"]["median_ms"] for run in theirs)
    print(f"{mesh.name}, {theirs[0]['triangles']:,} triangles, {arguments.size}, medians of {arguments.turns} runs in turns")
    print(f"frame        {frame:8.1f} ms   VTK {frame_vtk:8.1f} ms   ratio {frame / frame_vtk:.2f}")
    host = [run["host_cpu"]["median_ms"] for run in ours if "host_cpu" in run]
    if host:
        print(f"host CPU     {statistics.median(host):8.3f} ms   per frame, GL work aside")


def compare_processes(arguments, folder, mesh, program, display):
    if shutil.which("f3d") is None:
        print("whole render: f3d is not installed")
        return
    render = [program, "render", mesh, "-o", folder / "ours.png", "--size", arguments.size]
    f3d = ["f3d", mesh, "--output", folder / "theirs.png", "--resolution=" + arguments.size.replace("x", ",")]

    def row(name, ours, theirs, format):
        mine, other = statistics.median(ours), statistics.median(theirs)
        print(f"{name:<12} {format(mine)}   f3d {format(other)}   ratio {mine / other:.2f}")

    def seconds(value):
        return f"{value:8.2f} s "

    def megabytes(value):
        return f"{value / 1e6:8.0f} MB"

    ours, theirs, cold, cold_f3d = [], [], [], []
    for turn in range(arguments.turns):
        ours.append(measure_process(render))
        theirs.append(measure_process(f3d, display))
    for turn in range(min(3, arguments.turns)):
        fresh = {"MESA_SHADER_CACHE_DIR": str(folder / f"cache{turn}")}
        cold.append(measure_process(render, dict(os.environ, **fresh))[0])
        fresh = {"MESA_SHADER_CACHE_DIR": str(folder / f"f3d-cache{turn}")}
        cold_f3d.append(measure_process(f3d, dict(display, **fresh))[0])
    row("whole render", [run[0] for run in ours], [run[0] for run in theirs], seconds)
    row("  cold cache", cold, cold_f3d, seconds)
    row("peak memory", [run[1] for run in ours], [run[1] for run in theirs], megabytes)
    row("  all, PSS", [peak_of_all(render) for _ in range(3)], [peak_of_all(f3d, display) for _ in range(3)], megabytes)


def main():
    arguments = parse_arguments()
    program = arguments.build / "bin/lumenshop"
    with tempfile.TemporaryDirectory() as name, Display() as display:
        folder = pathlib.Path(name)
        mesh = pathlib.Path(arguments.mesh).resolve() if arguments.mesh else phantom(program, folder, arguments.triangles)
        if arguments.split:
            compare_splits(arguments, folder, mesh, program)
            return
        compare_frames(arguments, folder, mesh, program, display)
        if not (arguments.frame_only or arguments.transparent):
            compare_processes(arguments, folder, mesh, program, display)


if __name__ == "__main__":
    main()
