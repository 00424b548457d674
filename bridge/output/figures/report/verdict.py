"""What came out of a run, in words."""

from report import measures, numerals

NO_CHANGE = 0.2  # of the smallest lumen [%]
ENOUGH_DAYS = 5  # records below which nothing is said of how fast tissue grows


def headline(run):
    """The result in one sentence."""
    day = run.last("day") or 0
    if run.status == "occluded":
        return f"On day {numerals.shown(day)} new tissue has closed the lumen."
    if run.grows and run.last("neointimaAreaFraction") is not None:
        filled = measures.FILLED.last(run)
        if filled < 0.5:
            return f"After {days(day)}, hardly any new tissue has grown."
        return f"After {days(day)}, new tissue fills {numerals.shown(filled, 2)} % of the stented lumen."
    if run.has_flow:
        return f"The blood's wall shear stress is {measures.STRESS.shown(measures.STRESS.last(run))} in the mean."
    if run.has_tissue:
        return "The wall is deployed; no growth was asked for."
    return "Nothing was recorded yet that could be judged."


def days(number):
    return "1 day" if number == 1 else f"{numerals.shown(number)} days"


def sentences(run):
    """What else is to be known, a sentence each."""
    said = [_status(run), _thickness(run), _narrowing(run), _pace(run), _endothelium(run), _stress(run), _exact(run)]
    return [text for text in said if text]


def _status(run):
    day, planned = numerals.shown(run.last("day") or 0), run.planned_days()
    asked = f" of {numerals.shown(planned)}" if planned else ""
    if run.status == "interrupted":
        return f"The run was stopped on day {day}{asked}: this is the state so far. It goes on with --resume."
    if run.status == "failed":
        return f"The run failed after day {day}{asked}: the remarks say what is known, and this is the state before."
    if not run.ended_well:
        return f"The run has not come to its end: it is under way, or was killed. Its last record is of day {day}{asked}."
    return ""


def _thickness(run):
    if not run.grows or run.last("neointimaThickness_um") is None:
        return ""
    text = f"New tissue is {measures.THICKNESS.shown(measures.THICKNESS.last(run))} thick in the mean"
    most = measures.THICKEST.last(run)
    return text + (f", and {measures.THICKEST.shown(most)} where it is thickest." if most else ".")


def _narrowing(run):
    before, now = measures.AREA.first(run), measures.AREA.last(run)
    if not run.grows or not before or now is None:
        return ""
    loss = measures.late_loss(run)
    change = 100 * (now / before - 1)
    if abs(change) < NO_CHANGE:
        return f"The smallest lumen is as wide as on day 0, {measures.AREA.shown(now)}."
    verb = "narrowed" if change < 0 else "widened"
    area = f"from {numerals.shown(before)} to {numerals.shown(now)} mm²"
    late = f", a late loss of {numerals.shown(loss, 2)} mm in diameter" if loss > 0 else ""
    return f"The smallest lumen has {verb} by {numerals.shown(abs(change), 2)} %, {area}{late}."


def _pace(run):
    """How fast tissue grows at the end, beside its fastest: slopes over a quarter of the time."""
    known = [
        (day, value)
        for day, value in zip(run.series.get("day", ()), run.series.get("neointimaThickness_um", ()))
        if value is not None
    ]
    if not run.grows or len(known) < ENOUGH_DAYS:
        return ""
    window = max(1, (len(known) - 1) // 4)
    slopes = [
        ((later[1] - first[1]) / (later[0] - first[0]), (first[0] + later[0]) / 2)
        for first, later in zip(known, known[window:])
        if later[0] > first[0]
    ]
    if not slopes:
        return ""
    (fastest, when), (last, _) = max(slopes), slopes[-1]
    if fastest <= 0:
        return ""
    now = f"{numerals.shown(last, 2)} µm a day"
    if last <= 0.05 * fastest:
        return f"Growth has come to rest; it was fastest about day {numerals.shown(when, 2)}."
    if last < 0.7 * fastest:
        peak = f"it was {numerals.shown(fastest, 2)} about day {numerals.shown(when, 2)}"
        return f"Growth is slowing down: {now} at the end; {peak}."
    end = ": the run ends before growth does" if run.status == "finished" else ""
    return f"It still grows about as fast as it ever did, {now}{end}."


def _endothelium(run):
    if "endothelium" not in run.scene or run.last("coverage") is None or not run.has_tissue:
        return ""
    back = measures.COVERAGE.last(run)
    return f"Endothelium covers {numerals.shown(back, 2)} % of the cells at the lumen."


def _stress(run):
    stress, low = measures.STRESS.last(run), measures.LOW_SHARE.last(run)
    if stress is None:
        return "No flow was solved, so no wall shear stress held any cell back." if run.grows else ""
    text = f"Wall shear stress is {measures.STRESS.shown(stress)} in the mean"
    if low is None or not run.grows:
        return "" if not run.grows else text + "."
    return f"{text}; on {numerals.shown(low, 2)} % of the wall it is too low to put cells to rest."


def _exact(run):
    error = run.summary.get("poiseuille")
    if not error:
        return ""
    off = 100 * abs(error["meanError"])
    said = f"{numerals.shown(off, 2)} %" if off >= 0.01 else "less than 0.01 %"
    return f"By Poiseuille's law it is {numerals.shown(error['exactWss_Pa'])} Pa in this tube: the mean is {said} off."
