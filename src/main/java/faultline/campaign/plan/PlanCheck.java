package faultline.campaign.plan;

import faultline.control.ControllerSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * Tries every level of every factor in every kind of world of a plan, one level at a time, so that an invalid value is
 * reported at its location in the plan before any run. Draws are tried at the ends of their ranges. After very many
 * trials, only the constant changes are tried in each further world.
 */
final class PlanCheck {

    /** The number of trials, each of which takes about 0.1 ms in a room, after which levels are not tried. */
    private static final int MAX_TRIALS = 50_000;

    private final CampaignPlan plan;
    private final Problems problems;
    private int trials;

    PlanCheck(String file, CampaignPlan plan) {
        this.plan = plan;
        this.problems = new Problems(file);
    }

    void check(PlanWorlds worlds, List<ScenarioChange> constants, List<Factor> factors) throws ScenarioException {
        Set<String> reported = new HashSet<>();
        boolean typeVaries = factors.stream().anyMatch(PlanCheck::setsType);
        for (WorldSource source : worlds.kinds()) {
            XmlElement root = source.root(0);
            check(source.label(0), root, constants, typeVaries, reported);
            for (Factor factor : factors) {
                boolean otherSetsType = typeVaries && !setsType(factor);
                for (Factor.Level level : factor.levels()) {
                    if (trials >= MAX_TRIALS) {
                        break;
                    }
                    List<ScenarioChange> edits = new ArrayList<>(constants);
                    edits.addAll(level.edits());
                    check(source.label(0), root, edits, otherSetsType, reported);
                }
            }
        }
        problems.throwIfAny();
    }

    /** Returns whether a factor sets the type of the controller, which no other factor does then. */
    private static boolean setsType(Factor factor) {
        return factor.levels().stream()
                .flatMap(level -> level.edits().stream())
                .anyMatch(edit -> edit instanceof ScenarioChange.SetAttribute set && isType(set.path()));
    }

    private static boolean isType(AttributePath path) {
        return path.attribute().equals("type")
                && path.steps().size() == 1
                && path.steps().get(0).element().equals("controller");
    }

    /** Checks some changes of a world, given whether another factor also sets the type of the controller. */
    private void check(
            String world, XmlElement root, List<ScenarioChange> edits, boolean typeVaries, Set<String> reported) {
        for (double uniform : uniforms(edits)) {
            if (uniform > 0 && trials >= MAX_TRIALS) {
                break;
            }
            trials++;
            try {
                Scenario scenario = Scenario.read("", plan.apply(root, edits, (stream, block) -> uniform, 0));
                if (scenario.setup().controller() instanceof ControllerSpec.Extern && !typeVaries) {
                    report(world, new Problem("", SourceLocation.NONE, PlanProblem.EXTERN.with()), edits, reported);
                }
            } catch (ScenarioException e) {
                for (Problem problem : e.problems()) {
                    report(world, problem, edits, reported);
                }
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
     * Reports a problem. If its location is in the scenario instead of the plan, it is reported at the level's last
     * change.
     */
    private void report(String world, Problem problem, List<ScenarioChange> edits, Set<String> reported) {
        boolean inPlan = edits.stream().anyMatch(edit -> edit.location().equals(problem.location()));
        SourceLocation location = inPlan || edits.isEmpty()
                ? problem.location()
                : edits.get(edits.size() - 1).location();
        if (reported.add(location.toString() + problem.message())) {
            problems.add(location, PlanProblem.IN_WORLD.with(problem.message(), world));
        }
    }
}
