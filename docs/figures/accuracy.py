#!/usr/bin/python3
"""Writes the page of what accuracy costs, and its diagrams, from the runs of the validation scenes.

usage: docs/figures/accuracy.py FOLDER

Reads FOLDER/accuracy.jsonl, in which a later run replaces an earlier one of the same scene, preset and
resolution; writes it again in order, FOLDER/accuracy.md and FOLDER/img/accuracy_SCENE.svg. Needs
python3-matplotlib. deploy/reproduce accuracy makes the runs.
"""
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESETS = ["standard", "paper"]
STYLE = {"standard": {"linestyle": "-", "marker": "o"}, "paper": {"linestyle": "--", "marker": "s"}}

INTRODUCTION = """# What accuracy costs

Every scene here has an answer that does not come from this program: a closed form, or a calculation by other
means (`tests/validation/references.json` says which). Each ran at several resolutions, N particle spacings over
the vessel's height (of cells in shear: over the cell's diameter); the errors are relative to the reference. The
order beside an error is that between this row and the one above, ln(e1/e2) / ln(N2/N1). One thread. The
processor's time is what the run takes by the clock on an idle machine; the clock itself ran while the machine had
other work, too. Diagrams: error against N and
against the processor's time; standard preset drawn through, paper dashed.

This page is made by `deploy/reproduce accuracy` (a scene alone: `deploy/reproduce accuracy bump_032`), which draws
it from `accuracy.jsonl`; `--draw` draws it again without running anything.
"""

PAPER = """The preset `paper` stands beside the standard one in plain Poiseuille flow, for which the study prints a deviation
(3.66 %), at N = 12, 17 and 25. Its step goes with the square of the spacing, from the study's at N = 25; twice the N is
sixteen times the work, so it ends there. It is left out of the other scenes: for those the study has
no figure to hold it against."""

RING = """Periodic vessel of 8 x 8 cell diameters, walls that move, Re = 1.5e-3, mean from 7/G to 9/G. Deformation
(of the ellipse of the same moments) and perimeter relative to the reference, inclination in pi. In twice the box
deformations are the same within 0.5 % (N = 8). """

VESICLE = """The same box, from the reference's inclination, mean from 2/G to 5/G. The perimeter stretches by 0.1 %
(E_s = 20000 B/R²); mu G R³/B = 10. period: of tank-treading."""

CELLS = """Beside the scenes with cells below, two that run no flow: the biconcave rest shape is the elastica within 0.42 %
with 50 nodes and 0.15 % with 200 (asked: 1 and 0.2 %; `ctest --preset release -R BiconcaveShape`), and the membrane's
forces are the derivatives of its energies within 1e-6 (`ctest --preset release -R ElasticForces`)."""

# Title, and what the scene is and what its errors mean.
SCENES = {
    "couette_start": (
        "Couette flow from rest",
        "Periodic vessel, upper wall at 5 mm/s from time 0. Greatest error of u over all particles, over "
        "the wall's speed, when 0.05, 0.1, 0.2 and 0.5 H²/ν have passed. Steps of H²/ν / 4N, or what the "
        "limit on their error allows.",
    ),
    "poiseuille_start": (
        "Poiseuille flow from rest",
        "The same vessel, driven by a body's acceleration; over the greatest velocity of the steady flow.",
    ),
    "poiseuille_plug": (
        "Poiseuille flow, plug inlet",
        "Section 2.5 of the study: 8 H long, 1 ms, deviation from the parabola by eq. 22 over the last "
        "half: its mean and its worst; flux_ripple is half the range of the flow at the outlet there over "
        "its mean. A quadratic fit holds a parabola exactly: this tests the open ends and the walls, not "
        "convergence.",
    ),
    "poiseuille_parabolic": (
        "Poiseuille flow, parabolic inlet",
        "As above.",
    ),
    "long_channel": (
        "A channel of 40 diameters",
        "Parabolic inlet, 1 ms. Greatest difference of u between x = 39 H and 20 H, and from the parabola "
        "at 39 H, over the mean velocity.",
    ),
    "womersley": (
        "Flow that reverses",
        "Sinusoidal flux of Womersley number 2.5 in a vessel of 3 H, five cycles from rest; the plasma "
        "moves to and fro by a third of H. Error of u at mid-vessel at 16 phases of cycles 2 to 5, greatest "
        "and rms, over the flux's amplitude; drift of the number of particles.",
    ),
    "taylor_green": (
        "Decaying vortices",
        "Periodic box, Re = 100 by its side. Error of velocity, rms and greatest over all particles, over "
        "the vortices' own, and of the decay rate, after the time in which the greatest velocity would "
        "cross the box.",
    ),
    "hydrostatic": (
        "Plasma at rest under its weight",
        "Closed box, 100 µm. Greatest error of pressure over ρgH, and greatest speed.",
    ),
    "cavity_re100": (
        "Cavity with a moving lid, Re = 100",
        "Greatest deviation from the spectral values of u on the vertical and of v on the horizontal "
        "through the middle, over the lid's speed, after 20 crossings of the lid.",
    ),
    "bump_016": (
        "Stokes flow over a bump of 0.16 H",
        "Vessel of 6 H, parabolic inlet, Re = 0.05. Greatest velocity in the throat, pressure drop beyond "
        "the free vessel's, shear stress on the crest.",
    ),
    "bump_032": (
        "Stokes flow over a bump of 0.32 H",
        "As above; throat_profile is the greatest relative error at six points across the throat.",
    ),
    "bump_048": (
        "Stokes flow over a bump of 0.48 H",
        "As above.",
    ),
    "bump_pair": (
        "Stokes flow between two bumps of 0.24 H",
        "As above, a bump on each wall.",
    ),
    "bifurcation": (
        "A symmetric bifurcation",
        "Trunk of 20 µm into two branches of 10 µm, 60°. The lower branch's share against one half.",
    ),
    "bifurcation_unequal": (
        "A bifurcation into unequal branches",
        "Branches of 12 and 8 µm, ten diameters long, against resistances 12 μL/D³ in parallel. That law "
        "leaves out what the junction takes: L is the length of a branch's outer wall, and where it begins "
        "is uncertain by about half a diameter, 5 % of the length, which the shares feel only by its "
        "difference between the two. So the error does not go to 0 with the spacing.",
    ),
    "ring_soft": (
        "An elastic ring in shear",
        RING + "Ca = 0.125, without bending.",
    ),
    "ring_stiff": (
        "A stiff ring in shear",
        "As above, Ca = 0.0125.",
    ),
    "ring_bending": (
        "A ring that resists bending in shear",
        "As above, Ca = 0.125 and B = 0.05 E_s R². In the reference the bending moment is B times the "
        "curvature; here it is B times the turn of the tangent per *unstretched* length, the derivative of "
        "an energy (eq. 11 in conservative form). The two part where the ring is stretched: this scene's "
        "errors hold that difference, 1.5 % of the deformation. Those called conservative are against the same "
        "calculation with the moment as it is here (`tests/validation/boundary_integral.py`, which gives the other "
        "references of rings within 0.4 %).",
    ),
    "vesicle_090": (
        "A vesicle in shear, area 0.9",
        VESICLE,
    ),
    "vesicle_080": (
        "A vesicle in shear, area 0.8",
        "As above.",
    ),
    "vesicle_080_ratio_2": (
        "The same, twice as viscous inside",
        "Mean from 10/G to 13/G.",
    ),
    "vesicle_080_ratio_4": (
        "The same, four times as viscous inside",
        "Near the threshold of tumbling, where the inclination depends most on everything.",
    ),
    "vesicle_090_inextensible": (
        "A vesicle whose membrane keeps its length, area 0.9",
        "As with the stiff spring, by the effect `inextensible` (docs/effects/inextensible.md).",
    ),
    "vesicle_080_inextensible": (
        "The same, area 0.8",
        "As above.",
    ),
    "vesicle_080_ratio_4_inextensible": (
        "The same, four times as viscous inside",
        "As above.",
    ),
    "thrombus_inextensible": (
        "A cell whose membrane keeps its length past a thrombus",
        "The study's cell and thrombus of 8 d0, 7 ms: what any link, and the perimeter, is ever off by.",
    ),
    "adhering_vesicles": (
        "Two vesicles that adhere",
        "Of reduced area 0.8, at rest, for adhesions w R²/B of 4 and 16: the length of their contact and the size of one "
        "across and along it (docs/effects/aggregation.md). N spacings over 2R. The reference's potential has no "
        "range, this one R/100.",
    ),
    "rouleau": (
        "A stack of three cells in shear",
        "1 where it breaks in slow shear, or holds in fast (docs/effects/aggregation.md).",
    ),
    "vesicle_tumbling": (
        "From which viscosity ratio on a vesicle tumbles",
        "Area 0.9. By the reference one of ratio 5 treads and one of 5.5 tumbles. Runs from an inclination of 0 over "
        "20/G, by steps of 0.5 in the ratio, until one that treads and one that tumbles are neighbours; by how "
        "much they are off.",
    ),
    "cell_in_channel": (
        "A cell in a free channel",
        "The study's cell and vessel with E_s = 1e-4 N/m. Velocity over U at x = 20, 32, 44 and 59 µm, the "
        "greatest error of the four, and tau over the enclosed area at 59 µm, each the mean over 2 µm. The "
        "reference is itself given as within 1.5 %, so the order of convergence is that of the values among "
        "themselves: a little under 1 for the velocity at 59 µm. Further upstream the coarsest are too near to the "
        "finest for an order, and tau is the same within 0.15 % from N = 32 on. From N = 40 and 80 straight on to a "
        "spacing of 0 the velocities are 1.223, 1.242 and 1.249 at 32, 44 and 59 µm. Half the step changes them "
        "by less than 0.1 % at N = 32.",
    ),
    "resting_cell": (
        "A cell at rest",
        "The study's cell in plasma that nothing moves, 3 ms. Drift of its centroid over its radius (3.18 µm) a "
        "millisecond, and the greatest speed of any particle after 0.1 ms over 5 mm/s.",
    ),
}


def read_runs(path):
    runs = {}
    for line in path.read_text().splitlines():
        run = json.loads(line)
        runs[run["scene"], PRESETS.index(run["preset"]), run["across"]] = run
    names = list(SCENES)
    ordered = sorted(runs.items(), key=lambda item: (names.index(item[0][0]), *item[0][1:]))
    return [run for _, run in ordered]


def of(runs, scene, preset=None):
    return [run for run in runs if run["scene"] == scene and preset in (None, run["preset"])]


def completed(runs):
    return [run for run in runs if run["outcome"] == "completed"]


def order(coarse, fine, name):
    before, after = coarse["errors"][name], fine["errors"][name]
    if min(before, after) <= 0 or coarse["across"] == fine["across"]:
        return None
    return math.log(before / after) / math.log(fine["across"] / coarse["across"])


def converging_order(done, name):
    """Of a value in the spacing, from the finest three runs of which each has twice the N of the one before it, and
    which these are. The order is None where the value does not converge; None alone, where there are no such runs."""
    by_resolution = {run["across"]: run["values"][name] for run in done}
    for fine in sorted(by_resolution, reverse=True):
        if fine % 4 == 0 and {fine // 4, fine // 2} <= by_resolution.keys():
            coarse, middle, finest = (by_resolution[n] for n in (fine // 4, fine // 2, fine))
            ratio = (coarse - middle) / (middle - finest) if middle != finest else 0
            return (math.log2(ratio) if ratio > 0 else None), f"N = {fine // 4}, {fine // 2}, {fine}"
    return None


def number(value):
    return f"{value:.2e}" if value < 1e-3 else f"{value:.3g}"


def seconds(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def row(run, before, names):
    cells = [run["preset"], str(run["across"])]
    for name in names:
        if run["outcome"] != "completed":
            cells.append("failed")
            continue
        slope = order(before, run, name) if before else None
        cells.append(number(run["errors"][name]) + (f" ({slope:.1f})" if slope is not None else ""))
    return cells + [str(run.get("steps", "")), seconds(run["cpu_time"]), seconds(run["wall_time"])]


def table(rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in rows]
    return "\n".join([lines[0], "|" + " --- |" * len(rows[0]), *lines[1:]])


def scene_table(runs, names):
    rows = [["preset", "N", *names, "steps", "processor, s", "clock, s"]]
    for preset in PRESETS:
        before = None
        for run in of(runs, runs[0]["scene"], preset):
            rows.append(row(run, before, names))
            if run["outcome"] == "completed":
                before = run
    return table(rows)


def asked_table(runs, asked):
    """What is asked of each scene beside what it came to in the standard preset."""
    rows = [["scene", "asked", "reached", ""]]
    for scene, goal in asked.items():
        done = completed(of(runs, scene, "standard"))
        at_resolution = [run for run in done if run["across"] == goal["across"]]
        for name, most in goal["errors"].items():
            reached, met = "not run, or failed", "open"
            if at_resolution:
                value = at_resolution[0]["errors"][name]
                reached, met = number(value), "yes" if value <= most else "**no**"
            rows.append([scene, f"{name} at most {most:g} at N = {goal['across']}", reached, met])
        for name, least in goal.get("orders", {}).items():
            slope = order(done[0], done[-1], name) if len(done) > 1 else None
            reached, met = "not run, or failed", "open"
            if slope is not None:
                span = f", N = {done[0]['across']} to {done[-1]['across']}"
                reached, met = f"{slope:.2f}{span}", "yes" if slope >= least else "**no**"
            rows.append([scene, f"{name}: order at least {least:g}", reached, met])
        for name, least in goal.get("value_orders", {}).items():
            found = converging_order(done, name)
            reached, met = "not run, or failed", "open"
            if found:
                slope, span = found
                reached = f"{slope:.2f}, {span}" if slope is not None else f"none, {span}"
                met = "yes" if slope is not None and slope >= least else "**no**"
            rows.append([scene, f"{name}: order at least {least:g}", reached, met])
    return table(rows)


def value_table(done):
    """What was measured, where the runs say so, and by what order it converges."""
    names = list(done[0]["values"])
    rows = [["N", *names]]
    rows += [[str(run["across"]), *(f"{run['values'][name]:.4f}" for name in names)] for run in done]
    orders = [converging_order(done, name) for name in names]
    if all(orders):
        rows.append([f"order, {orders[0][1]}", *(f"{o[0]:.2f}" if o[0] is not None else "none" for o in orders)])
    return table(rows)


def draw(runs, names, path):
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.2), sharey=True, layout="constrained")
    for column, name in enumerate(names):
        for preset in PRESETS:
            done = [run for run in completed(of(runs, runs[0]["scene"], preset)) if run["errors"][name] > 0]
            errors = [run["errors"][name] for run in done]
            label = name if preset == "standard" else None
            for axis, along in zip(axes, ("across", "cpu_time")):
                axis.loglog([run[along] for run in done], errors, color=f"C{column}", label=label, **STYLE[preset])
    axes[0].set(xlabel="N", ylabel="error")
    axes[1].set(xlabel="processor's time, s")
    across = sorted({run["across"] for run in runs})
    axes[0].set_xticks(across, [str(n) for n in across])
    axes[0].set_xticks([], minor=True)
    for axis in axes:
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize="small")
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def section(runs, scene, folder):
    title, text = SCENES[scene]
    own = of(runs, scene)
    parts = [f"## {title}", "", f"`{scene}`, reference: {own[0]['reference']}. {text}", ""]
    done = completed(own)
    names = list(done[0]["errors"]) if done else ["error"]
    parts += [scene_table(own, names), ""]
    for run in own:
        if run["outcome"] != "completed":
            parts += [f"{run['preset']}, N = {run['across']}: {run['message']}.", ""]
    if done and "values" in done[0]:
        parts += [value_table(of(done, scene, "standard")), ""]
    if done:
        picture = folder / "img" / f"accuracy_{scene}.svg"
        draw(own, names, picture)
        parts += [f"![{title}: error against N and time](img/{picture.name})", ""]
    return parts


def main():
    folder = pathlib.Path(sys.argv[1])
    # Texts as texts, and names that do not change from one drawing to the next.
    plt.rcParams.update({"svg.hashsalt": "rouleau", "svg.fonttype": "none", "font.size": 9})
    runs = read_runs(folder / "accuracy.jsonl")
    (folder / "accuracy.jsonl").write_text("".join(json.dumps(run) + "\n" for run in runs))
    asked = json.loads((ROOT / "tests/validation/references.json").read_text())["asked"]
    there = {run["scene"] for run in runs}
    parts = [INTRODUCTION, "## Asked and reached", ""]
    parts += [asked_table(runs, {name: goal for name, goal in asked.items() if name in there}), ""]
    parts += ["## Cells", "", CELLS, "", "## The published scheme", "", PAPER, ""]
    for scene in SCENES:
        if scene in there:
            parts += section(runs, scene, folder)
    (folder / "accuracy.md").write_text("\n".join(parts).rstrip() + "\n")


if __name__ == "__main__":
    main()
