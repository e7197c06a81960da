"""The command line. Heavy modules are imported by the commands, so that help comes at once."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from berthing._version import __version__
from berthing.commands import completion
from berthing.commands.guard import guarded
from berthing.export.formats import NAMES

app = typer.Typer(
    name="berthing",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    rich_markup_mode="markdown",
)

ScenarioName = Annotated[
    str,
    typer.Argument(
        help="A case that ships, or a YAML or JSON file.", autocompletion=completion.scenarios
    ),
]
TimeLimit = Annotated[
    float | None, typer.Option(metavar="S", help="Wall time allowed, in seconds.")
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON on standard output, only that.")]


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"berthing {__version__}")
        raise typer.Exit


@app.callback()
def berthing(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version."
        ),
    ] = False,
) -> None:
    """Plan collision-free, optimal motion for rigid bodies in tight spaces, with a proof.

    **Examples**

    - `berthing plan scenario-a`
    - `berthing view plans/scenario-a`
    - `berthing --install-completion`
    """


@app.command("plan")
def plan_command(
    scenario: ScenarioName,
    formulation: Annotated[
        str | None, typer.Option(help="How separation is written, e.g. plane.")
    ] = None,
    scheme: Annotated[str | None, typer.Option(help="How time is discretised, e.g. lgr.")] = None,
    nodes: Annotated[int | None, typer.Option(help="Collocation nodes to begin with.")] = None,
    out: Annotated[
        Path | None, typer.Option(help="The plan folder; plans/NAME of the scenario if not given.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an older plan folder.")] = False,
    time_limit: TimeLimit = None,
    seed: Annotated[int | None, typer.Option(help="Seed of the guesses.")] = None,
    guess: Annotated[
        str | None,
        typer.Option(help="First trajectories: default, routes, paper-continuation."),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(help="Refine until the Hamiltonian drifts by less than this of its mean."),
    ] = None,
    effort: Annotated[
        str | None,
        typer.Option(help="How far to look for a cheaper way: fast, normal or thorough."),
    ] = None,
    controls: Annotated[
        str | None,
        typer.Option(help="What flies: polynomial, piecewise-linear or piecewise-constant."),
    ] = None,
    sample_time: Annotated[
        float | None,
        typer.Option(metavar="S", help="Between samples of piecewise controls, in seconds."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Plan a scenario, prove the plan, and write a plan folder.

    The options overrule the scenario's own `solver:` block.

    **Exit code:** 0 certified · 2 bad usage or input · 3 no plan found ·
    4 a plan was found but is not certified · 130 interrupted

    **Examples**

    - `berthing plan scenario-a`
    - `berthing plan truss.yaml --out plans/truss --seed 3 --force`
    - `berthing plan scenario-b --json | jq .verification`
    - `berthing plan scenario-a --controls piecewise-constant --sample-time 0.5`
    """
    given = {
        "formulation": formulation,
        "scheme": scheme,
        "nodes": nodes,
        "time_limit_s": time_limit,
        "seed": seed,
        "guess": guess,
        "tolerance": tolerance,
        "effort": effort,
        "controls": controls,
        "sample_time_s": sample_time,
    }

    def work() -> int:
        from berthing.commands.planning import run

        return run(scenario, given, out, force=force, as_json=as_json)

    raise typer.Exit(guarded(work))


@app.command("route")
def route_command(
    scenario: ScenarioName,
    seed: Annotated[int, typer.Option(min=0, help="Seed of what is drawn.")] = 0,
    classes: Annotated[
        int, typer.Option(metavar="N", help="How many ways that cannot be swept into each other.")
    ] = 1,
    out: Annotated[
        Path | None, typer.Option(help="The folder; routes/NAME of the scenario if not given.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an older folder.")] = False,
    time_limit: TimeLimit = None,
    figures: Annotated[
        bool, typer.Option("--figures", help="Draw each route, as figures/route-N.png.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Find a path of the full shape, every leg of it certified as plans are, and write it.

    A route has no times, speeds or forces: it is collision-free however fast it is flown, as long
    as all vehicles keep in step. `berthing plan` finds motions. Writes route.json and route.csv.

    **Exit code:** 0 certified · 2 bad usage or input; nothing is written · 3 none found ·
    130 interrupted

    **Examples**

    - `berthing route scenario-b-tight`
    - `berthing route scenario-a --classes 4 --seed 1 --figures --out routes/four`
    - `berthing route scenario-b-tight --json | jq .routes[0].clearance_lower_bound_m`
    """

    def work() -> int:
        from berthing.commands import finding_routes

        return finding_routes.run(
            scenario, seed, classes, time_limit, out,
            force=force, figures=figures, as_json=as_json,
        )  # fmt: skip

    raise typer.Exit(guarded(work))


@app.command("verify")
def verify_command(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="A plan folder.")],
    as_json: AsJson = False,
    trust: Annotated[
        bool,
        typer.Option("--trust", help="Run code of the user's own that the scenario names."),
    ] = False,
    search: Annotated[
        bool,
        typer.Option("--search", help="Prove clearance anew instead of checking the certificate."),
    ] = False,
) -> None:
    """Check a plan folder again, from its files alone.

    Nothing of the solver is used: the check has its own equations of motion, and exact shapes. Only
    dynamics of the user's own have one source; they run with `--trust` alone.
    Clearance is what the normals in `certificate.json` prove, so that nothing is searched for; a
    forged or missing file leaves the plan uncertified. With `--search` that file is not read, and
    violations are found and named.

    **Exit code:** 0 certified · 2 bad usage or input · 4 not certified

    **Examples**

    - `berthing verify plans/scenario-a`
    - `berthing verify plans/scenario-a --json`
    - `berthing verify plans/scenario-a --search`
    """

    def work() -> int:
        from berthing.commands.verifying import run

        return run(folder, as_json=as_json, trust=trust, search=search)

    raise typer.Exit(guarded(work))


@app.command("export")
def export_command(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="A plan folder.")],
    to: Annotated[
        str | None,
        typer.Option(
            "--to", metavar="FORMAT", help=f"One of: {NAMES}.", autocompletion=completion.formats
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="The file; named after the scenario if not given."),
    ] = None,
    vehicle: Annotated[
        str | None, typer.Option(metavar="NAME", help="Only this vehicle, where there are several.")
    ] = None,
    meta: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="YAML or JSON with keys that overrule the scenario's `meta:`."
        ),
    ] = None,
    trust: Annotated[
        bool,
        typer.Option("--trust", help="Run code of the user's own that the scenario names."),
    ] = False,
) -> None:
    """Write a plan as a file that other tools read.

    Orbit and attitude formats need to know the epoch, the frame, its centre and who flies: the
    scenario's `meta:` block says so, or a file given by `--meta`.

    **Exit code:** 0 written · 2 bad usage or input; nothing is written · 130 interrupted

    **Examples**

    - `berthing export plans/scenario-a --to mat`
    - `berthing export plans/truss --to oem --out truss.oem`
    - `berthing export plans/truss --to aem --meta mission.yaml --vehicle carrier`
    """

    def work() -> int:
        from berthing.commands.exporting import run

        return run(folder, to, out, vehicle, meta, trust=trust)

    raise typer.Exit(guarded(work))


@app.command("view")
def view_command(
    folders: Annotated[
        list[Path], typer.Argument(metavar="DIR...", help="Plan folders; several are compared.")
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="The page; report.html in the folder, or compare.html here, if not given.",
        ),
    ] = None,
    open_it: Annotated[
        bool, typer.Option("--open/--no-open", help="Open it in a browser, given a display.")
    ] = True,
    trust: Annotated[
        bool,
        typer.Option("--trust", help="Run code of the user's own that the scenario names."),
    ] = False,
) -> None:
    """Show a plan, or several in one scene, as a page that needs no network.

    The verdict is the one that the folder records; `berthing verify` checks it again.

    **Exit code:** 0 written · 2 bad usage or input

    **Examples**

    - `berthing view plans/scenario-a`
    - `berthing view plans/one plans/two --out both.html`
    """

    def work() -> int:
        from berthing.commands.viewing import run

        return run(folders, out, open_it=open_it, trust=trust)

    raise typer.Exit(guarded(work))


@app.command("decompose")
def decompose_command(
    file: Annotated[Path, typer.Argument(help="STL, OBJ, PLY, GLB or URDF.")],
    units: Annotated[
        str | None, typer.Option(help="Of the file's numbers: m, cm, mm, in … Never guessed.")
    ] = None,
    volume_ratio: Annotated[
        float, typer.Option(help="Volume of the pieces over that of the mesh, to aim at.")
    ] = 1.15,
    largest_push: Annotated[
        float | None,
        typer.Option(metavar="M", help="Most by which faces may be moved out, in metres."),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the cuts.")] = 0,
    density: Annotated[
        float | None, typer.Option(metavar="KG/M3", help="For the mass; a URDF has its own.")
    ] = None,
    joint: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=POSITION", help="A joint of a URDF, in rad or m; else 0."),
    ] = None,
    check: Annotated[
        Path | None,
        typer.Option(metavar="PIECES", help="Prove the pieces in this file again instead."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="The folder; pieces/NAME of the file if not given.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Write into a folder in use.")] = False,
    as_json: AsJson = False,
) -> None:
    """Cover a mesh, or a robot's links, with convex pieces, and prove that nothing sticks out.

    Writes pieces.json, whose parts a scenario can hold, and pictures. A scenario may also name the
    file itself. Needs the extra `mesh`: `pip install 'berthing[mesh]'`.

    **Exit code:** 0 proven · 2 bad usage or input · 4 with `--check`: the proof does not hold

    **Examples**

    - `berthing decompose bracket.stl --units mm --density 2700`
    - `berthing decompose robot.urdf --joint elbow=0.7 --out pieces/robot`
    - `berthing decompose bracket.stl --check pieces/bracket/pieces.json`
    """

    def work() -> int:
        from berthing.commands import decomposing

        if check is not None:
            return decomposing.check(file, check, as_json=as_json)
        return decomposing.run(
            file,
            {"volume_ratio": volume_ratio, "largest_push_m": largest_push, "seed": seed},
            {"units": units, "density_kg_m3": density},
            joint or [],
            out,
            force=force,
            as_json=as_json,
        )

    raise typer.Exit(guarded(work))


@app.command("compare")
def compare_command(
    scenario: Annotated[str, typer.Argument(help="A case that ships, or a YAML or JSON file.")],
    formulation: Annotated[
        list[str] | None, typer.Option(help="One to compare; say it again for more. All if none.")
    ] = None,
    guesses: Annotated[
        int | None, typer.Option(help="How many guesses; all of the planner's if not given.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the guesses.")] = 0,
    time_limit: Annotated[
        float, typer.Option(metavar="S", help="Wall time of each solve, in seconds.")
    ] = 60.0,
    out: Annotated[
        Path | None, typer.Option(help="Write it to this file too: .json or .md.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Solve one case by several formulations from the same guesses, and put them side by side.

    Separation is asked for at the nodes only; the last column shows what the true shapes keep
    between them. Nothing is certified: `berthing plan` does that.

    **Exit code:** 0 done · 2 bad usage or input · 130 interrupted

    **Examples**

    - `berthing compare scenario-b-tight`
    - `berthing compare scenario-a --formulation plane --formulation kkt --guesses 4 --out a.md`
    """

    def work() -> int:
        from berthing.commands import comparing

        return comparing.run(
            scenario, formulation or (), guesses, seed, time_limit, out, as_json=as_json
        )

    raise typer.Exit(guarded(work))


@app.command("reproduce")
def reproduce_command(
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="An empty folder, or one that is not there yet.")
    ] = Path("reproduction"),
) -> None:
    """Make every figure of the paper anew, and a table of its claims with what was found.

    Takes a minute or two: Scenarios A and B are planned, in the paper's form and as printed.

    **Exit code:** 0 written · 2 bad usage or input · 130 interrupted

    **Examples**

    - `berthing reproduce`
    - `berthing reproduce --out /tmp/paper`
    """

    def work() -> int:
        from berthing.commands.reproducing import run

        return run(out)

    raise typer.Exit(guarded(work))


@app.command("scenarios")
def scenarios_command(as_json: AsJson = False) -> None:
    """List the cases that ship; any of these names will do as SCENARIO.

    **Examples**

    - `berthing scenarios`
    - `berthing plan scenario-b-tight`
    """

    def work() -> int:
        from berthing.commands.listing import print_scenarios

        return print_scenarios(as_json=as_json)

    raise typer.Exit(guarded(work))


@app.command("schema")
def schema_command() -> None:
    """Print the JSON Schema of the scenario file, for editors and checkers.

    **Examples**

    - `berthing schema > scenario.schema.json`
    """

    def work() -> int:
        from berthing.commands.listing import print_schema

        return print_schema()

    raise typer.Exit(guarded(work))


@app.command("doctor")
def doctor_command(as_json: AsJson = False) -> None:
    """Print versions, and solve the case whose cost is known in closed form, with its error.

    From rest to rest with nothing in the way the least cost is 12 m² d²/T³.

    **Exit code:** 0 all is well · 4 the answer is off, or not certified

    **Examples**

    - `berthing doctor`
    - `berthing doctor --json | jq .closed_form.relative_error`
    """

    def work() -> int:
        from berthing.commands.doctoring import run

        return run(as_json=as_json)

    raise typer.Exit(guarded(work))


BLAS_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")
"""Matrices here are small: threads that wait for them to grow take the cores from other guesses."""


def main() -> None:
    """Entry point of the ``berthing`` script."""
    for name in BLAS_THREADS:
        os.environ.setdefault(name, "1")
    app()
