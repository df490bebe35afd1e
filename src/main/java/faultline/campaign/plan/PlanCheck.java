package faultline.campaign.plan;

import faultline.control.ControllerSpec;
import faultline.io.Message;
import faultline.scenario.Scenario;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Tries every level of every factor in every kind of world of a plan, one level at a time, so that an invalid value is
 * reported at its location in the plan before any run. Draws are tried at the ends of their ranges. After very many
 * trials or problems, only the constant changes are tried in each further world, and after very many of them none.
 */
final class PlanCheck {

    /**
     * The sum of the {@linkplain #size sizes} of scenarios after which levels are not tried; it takes several seconds.
     */
    private static final long MAX_TRIED = 100_000;

    /** The sum of the sizes of worlds and of their constant changes after which no further world is tried. */
    private static final long MAX_IN_WORLDS = 300_000;

    /** The characters of attributes that take as long to check as an element. */
    private static final int TEXT_PER_ELEMENT = 4000;

    private final CampaignPlan plan;
    private final Problems problems;
    private final List<ScenarioChange> constants;
    private final Set<SourceLocation> constantLocations;
    private final Set<String> reported = new HashSet<>();
    private long tried;
    private long triedInWorlds;

    /** Creates a check of a plan in a file, whose changes of every scenario are given. */
    PlanCheck(String file, CampaignPlan plan, List<ScenarioChange> constants) {
        this.plan = plan;
        this.problems = new Problems(file);
        this.constants = constants;
        this.constantLocations =
                constants.stream().map(ScenarioChange::location).collect(Collectors.toSet());
    }

    void check(PlanWorlds worlds, List<Factor> factors) throws ScenarioException {
        boolean typeVaries = factors.stream().anyMatch(PlanCheck::setsType);
        for (WorldSource source : worlds.kinds()) {
            if (triedInWorlds >= MAX_IN_WORLDS) {
                break;
            }
            check(source, factors, typeVaries);
        }
        problems.throwIfAny();
    }

    private void check(WorldSource source, List<Factor> factors, boolean typeVaries) {
        XmlElement root;
        triedInWorlds += constants.size();
        try {
            root = plan.apply(source.root(0), constants, (stream, block) -> 0, 0);
        } catch (ScenarioException e) {
            report(source.label(0), e.problems(), List.of());
            return;
        }
        CheckedWorld world = new CheckedWorld(source.label(0), root, size(root));
        triedInWorlds += world.size;
        check(world, List.of(), typeVaries);
        for (Factor factor : factors) {
            boolean otherSetsType = typeVaries && !setsType(factor);
            for (Factor.Level level : factor.levels()) {
                if (isEnough()) {
                    return;
                }
                check(world, level.edits(), otherSetsType);
            }
        }
    }

    /** Returns whether the check takes long, or has found many problems, so that no more levels are tried. */
    private boolean isEnough() {
        return tried >= MAX_TRIED || reported.size() >= 10 * Problems.MAX_LISTED;
    }

    /** A world with the constant changes, its name, and its size. */
    private record CheckedWorld(String name, XmlElement root, long size) {}

    /** Returns the number of elements, and a share for the text of their attributes. */
    private static long size(XmlElement node) {
        long text =
                node.attributes().values().stream().mapToLong(String::length).sum();
        return 1
                + text / TEXT_PER_ELEMENT
                + node.children().stream().mapToLong(PlanCheck::size).sum();
    }

    /** Returns whether a factor sets the type of the controller, which no other factor does then. */
    private static boolean setsType(Factor factor) {
        return factor.settingLevels().stream()
                .flatMap(level -> level.edits().stream())
                .anyMatch(edit -> edit instanceof ScenarioChange.SetAttribute set
                        && set.path().isControllerType());
    }

    /** Checks some changes of a world, given whether another factor also sets the type of the controller. */
    private void check(CheckedWorld world, List<ScenarioChange> edits, boolean typeVaries) {
        for (double uniform : uniforms(edits)) {
            if (uniform > 0 && isEnough()) {
                return;
            }
            tried += world.size + edits.size();
            try {
                Scenario scenario = Scenario.read("", plan.apply(world.root, edits, (stream, block) -> uniform, 0));
                if (scenario.setup().controller() instanceof ControllerSpec.Extern && !typeVaries) {
                    Problem outside = new Problem("", SourceLocation.NONE, PlanProblem.EXTERN.with());
                    report(world.name, List.of(outside), edits);
                }
            } catch (ScenarioException e) {
                report(world.name, e.problems(), edits);
            }
        }
    }

    /**
     * Returns the draws that give both ends of every interval and every word of every choice; one draw if nothing is
     * drawn.
     */
    private static Set<Double> uniforms(List<ScenarioChange> edits) {
        Set<Double> uniforms = new TreeSet<>(Set.of(0.0));
        edits.stream()
                .flatMap(edit -> edit.values().stream())
                .flatMap(value -> value.ranges().stream())
                .forEach(range -> {
                    uniforms.add(Math.nextDown(1.0));
                    if (range instanceof DrawRange.Words choice) {
                        for (int i = 0; i < choice.words().size(); i++) {
                            uniforms.add((i + 0.5) / choice.words().size());
                        }
                    }
                });
        return uniforms;
    }

    /**
     * Reports problems. One whose location is in the scenario instead of the plan is reported at the level's last
     * change.
     */
    private void report(String world, List<Problem> found, List<ScenarioChange> edits) {
        List<ScenarioChange> last = edits.isEmpty() ? constants : edits;
        Set<SourceLocation> changed =
                edits.stream().map(ScenarioChange::location).collect(Collectors.toSet());
        for (Problem problem : found) {
            boolean inPlan = changed.contains(problem.location()) || constantLocations.contains(problem.location());
            SourceLocation location = inPlan || last.isEmpty()
                    ? problem.location()
                    : last.get(last.size() - 1).location();
            if (reported.add(location.toString() + problem.message())) {
                problems.add(location, PlanProblem.IN_WORLD.with(inWordsOfPlan(problem, edits), world));
            }
        }
    }

    /** Names lasts, which a plan may have instead of until. */
    private static Message inWordsOfPlan(Problem problem, List<ScenarioChange> edits) {
        Message message = problem.message();
        boolean isUntil = message.template() == ProblemKind.UNTIL
                || message.template() == ProblemKind.VALUE
                        && message.arguments().get(0).equals("until");
        boolean lasts = edits.stream()
                .filter(edit -> edit.location().equals(problem.location()))
                .flatMap(edit -> edit.values().stream())
                .anyMatch(AttributeValue.Sum.class::isInstance);
        return isUntil && lasts ? PlanProblem.LASTS.with(message) : message;
    }
}
