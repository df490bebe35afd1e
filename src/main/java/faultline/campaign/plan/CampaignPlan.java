package faultline.campaign.plan;

import faultline.scenario.Scenario;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The runs of a study. A <em>block</em> is a world with a seed and one value of everything that is drawn; a
 * <em>cell</em> is one combination of the levels of all factors. Every cell is run in every block, so that two cells
 * are compared on the same worlds, seeds and draws. Runs are numbered from 0, block by block.
 */
public final class CampaignPlan {

    /** The maximum number of runs; more are considered a mistake. */
    public static final long MAX_RUNS = 10_000_000;

    /** The greatest absolute value of a seed, and the greatest number of a generated room. */
    public static final long MAX_SEED = 1_000_000_000_000L;

    /** The columns before those of the factors. */
    public static final List<Column> RUN_COLUMNS = List.of(
            new Column("run", "", "number of the run in the plan, from 0"),
            new Column("block", "", "runs of one block have the same world, seed and draws"),
            new Column("world", "", "scenario or generated room"),
            new Column("seed", "", "seed of the simulation"));

    /** The reserved names, which a factor must not use for its columns: those above and those of the results. */
    public static final Set<String> RESERVED_COLUMNS = Set.of(
            "run",
            "block",
            "world",
            "seed",
            "outcome",
            "carried_on",
            "collided",
            "collision_time_s",
            "collided_with",
            "wall_share",
            "laps",
            "clock_start_s",
            "coverage",
            "distance_rms_m",
            "follow_rms_m",
            "final_state",
            "final_rung",
            "detection_delay_s",
            "false_alarms",
            "simulated_s",
            "trajectory_hash",
            "detection_view_s",
            "detection_error_m",
            "failure");

    private final String file;
    private final PlanHeader header;
    private final PlanFiles files;
    private final PlanWorlds worlds;
    private final Seeds seeds;
    private final List<ScenarioChange> commonChanges;
    private final List<Factor> factors;
    private final UniformSampler sampler;
    private final long cells;

    CampaignPlan(
            String file,
            PlanHeader header,
            PlanFiles files,
            PlanWorlds worlds,
            Seeds seeds,
            List<ScenarioChange> commonChanges,
            List<Factor> factors) {
        this.file = file;
        this.header = header;
        this.files = files;
        this.worlds = worlds;
        this.seeds = seeds;
        this.commonChanges = List.copyOf(commonChanges);
        this.factors = List.copyOf(factors);
        this.sampler = new UniformSampler(header.seed(), header.latin(), worlds.count() * seeds.count());
        this.cells =
                factors.stream().mapToLong(factor -> factor.levels().size()).reduce(1, (a, b) -> a * b);
    }

    /** {@return the files that the plan was read from} */
    public PlanFiles files() {
        return files;
    }

    /** {@return the attributes and the description of the root element} */
    public PlanHeader header() {
        return header;
    }

    /** {@return the number of worlds} */
    public int worldCount() {
        return worlds.count();
    }

    /** {@return the number of seeds with which each world is run} */
    public int seedCount() {
        return seeds.count();
    }

    /** {@return the number of combinations of levels} */
    public long cellCount() {
        return cells;
    }

    /** {@return the number of runs} */
    public long runCount() {
        return (long) worlds.count() * seeds.count() * cells;
    }

    /** {@return the names of the scenarios whose own timeline has faults, which act in all of their runs} */
    public List<String> scenariosWithFaults() {
        return worlds.kinds().stream()
                .filter(source -> source instanceof WorldSource.ScenarioFile scenario && scenario.hasFaults())
                .map(source -> source.label(0))
                .toList();
    }

    /**
     * {@return what the plan sets of the controller although the timeline of a scenario sets it again at a later time,
     * by the names of the scenarios and sorted} It names attributes, such as {@code distance}.
     */
    public Map<String, List<String>> overruledAttributes() {
        OverruledAttributes overruled = new OverruledAttributes(commonChanges, factors);
        Map<String, List<String>> found = new LinkedHashMap<>();
        for (WorldSource source : worlds.kinds()) {
            if (source instanceof WorldSource.ScenarioFile scenario) {
                found.put(scenario.label(), overruled.in(scenario));
            }
        }
        found.values().removeIf(List::isEmpty);
        return found;
    }

    /**
     * {@return a note on each path that sets an attribute of the first of several elements of a scenario because it
     * names none of them} The plan can be run.
     */
    public List<Problem> notes() {
        return PathNotes.of(file, worlds.kinds(), commonChanges, factors);
    }

    /** {@return the types of the controllers that drive the robots, in the order of the plan, each once} */
    public List<String> controllerTypes() {
        return ControllerTypes.of(worlds.kinds(), commonChanges, factors);
    }

    /** {@return the factors, in the order of the plan} */
    public List<FactorSummary> factors() {
        return factors.stream()
                .map(factor -> new FactorSummary(
                        factor.kind(), factor.columns(), factor.levels().size()))
                .toList();
    }

    /**
     * A factor as a report needs it.
     *
     * @param kind the kind of its element in the plan
     * @param columns its columns in {@code runs.csv}
     * @param levelCount the number of its levels; 1 if it is only drawn
     */
    public record FactorSummary(FactorKind kind, List<Column> columns, int levelCount) {}

    /** {@return the columns of everything that varies, in the order of the plan} */
    public List<Column> factorColumns() {
        return factors.stream().flatMap(factor -> factor.columns().stream()).toList();
    }

    /**
     * {@return a run}
     *
     * @param index the index, from 0 to less than {@link #runCount}
     */
    public PlannedRun run(long index) {
        long block = index / cells;
        List<String> texts = new ArrayList<>();
        for (Factor.Level level : levels(index % cells)) {
            level.cells().forEach(value -> texts.add(value.text(sampler, block)));
        }
        return new PlannedRun(index, block, worlds.label(world(block)), seed(block), texts);
    }

    private int world(long block) {
        return (int) (block / seeds.count());
    }

    private long seed(long block) {
        return seeds.first() + block % seeds.count();
    }

    /** Returns the levels of a cell; those of the last factor change fastest. */
    private List<Factor.Level> levels(long cell) {
        Factor.Level[] levels = new Factor.Level[factors.size()];
        long rest = cell;
        for (int i = levels.length - 1; i >= 0; i--) {
            int count = factors.get(i).levels().size();
            levels[i] = factors.get(i).levels().get((int) (rest % count));
            rest /= count;
        }
        return List.of(levels);
    }

    /**
     * {@return the scenario of a run}
     *
     * @param run one of this plan's runs
     * @throws ScenarioException if the plan's values, each valid by itself, do not make a valid scenario together
     */
    public Scenario scenario(PlannedRun run) throws ScenarioException {
        XmlElement tree = apply(worlds.root(world(run.block())), changes(run), sampler, run.block());
        return Scenario.read(file, withSeed(tree, run));
    }

    private List<ScenarioChange> changes(PlannedRun run) {
        List<ScenarioChange> changes = new ArrayList<>(commonChanges);
        levels(run.index() % cells).forEach(level -> changes.addAll(level.edits()));
        return changes;
    }

    /**
     * {@return whether a problem with the scenario of a run is at one of the plan's changes; otherwise its location is
     * one in the scenario's own file}
     *
     * @param run one of this plan's runs
     * @param problem a problem of {@link #scenario}
     */
    public boolean hasLocationOf(PlannedRun run, Problem problem) {
        return changes(run).stream().anyMatch(change -> change.location().equals(problem.location()));
    }

    private XmlElement withSeed(XmlElement tree, PlannedRun run) throws ScenarioException {
        AttributePath name = new AttributePath(List.of(), "name");
        ScenarioTree named = new ScenarioTree(tree);
        named.set(AttributePath.SEED, Long.toString(run.seed()), file, SourceLocation.NONE);
        named.set(name, "Run " + run.index(), file, SourceLocation.NONE);
        return named.toElement();
    }

    /** Makes changes in a tree, in their order. */
    XmlElement apply(XmlElement root, List<ScenarioChange> edits, AttributeValue.UniformSource numbers, long block)
            throws ScenarioException {
        ScenarioTree tree = new ScenarioTree(root);
        for (ScenarioChange edit : edits) {
            edit.apply(tree, numbers, block, file);
        }
        return ControllerTypes.withoutEarlierType(root, tree.toElement(), commonChanges, edits);
    }

    /** Checks every level of every factor in every kind of world, one at a time. */
    void check() throws ScenarioException {
        new PlanCheck(file, this, commonChanges).check(worlds, factors);
    }
}
