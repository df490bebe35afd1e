package faultline.campaign.plan;

import faultline.io.MessageText;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import faultline.scenario.xml.XmlFormat;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Makes a plan from the bytes of a file, or reports all problems. */
final class PlanReader {

    static final XmlFormat FORMAT = new XmlFormat("urn:faultline:campaign:1", "campaign");

    private static final List<String> CHILD_ELEMENTS =
            List.of("description", "worlds", "seeds", "set", "variants", "faults", "masks");
    private static final List<String> SINGLE_ELEMENTS = List.of("description", "worlds", "seeds");

    private static final Boolean[] SWITCH = {false, true};

    private final Problems problems;
    private final Map<String, byte[]> scenarios = new LinkedHashMap<>();
    private final List<ScenarioChange> constants = new ArrayList<>();
    private final List<Factor> factors = new ArrayList<>();

    private PlanReader(Problems problems) {
        this.problems = problems;
    }

    /**
     * Reads a plan, given the name of its file in problems, its content, and the source of the scenarios that it names.
     * Throws an exception with all problems.
     */
    static CampaignPlan read(String name, byte[] bytes, PlanFiles.Resolver resolver) throws ScenarioException {
        Problems problems = new Problems(name);
        if (bytes.length == 0) {
            problems.add(new SourceLocation(1, 1), PlanProblem.EMPTY.with());
        }
        problems.throwIfAny();
        PlanReader reader = new PlanReader(problems);
        Optional<CampaignPlan> plan =
                XmlElement.parse(bytes, problems, FORMAT).flatMap(root -> reader.read(name, bytes, root, resolver));
        problems.throwIfAny();
        plan.orElseThrow().check();
        return plan.get();
    }

    private Optional<CampaignPlan> read(String name, byte[] bytes, XmlElement root, PlanFiles.Resolver resolver) {
        if (!root.name().equals("campaign")) {
            problems.add(root, PlanProblem.ROOT.with(MessageText.oneLine(root.name()), FORMAT.namespace()));
            return Optional.empty();
        }
        ElementRules.checkChildren(root, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(root, SINGLE_ELEMENTS, problems);
        PlanHeader header = readHeader(root);
        List<WorldSource> worlds = new WorldsReader(problems, resolver, scenarios).read(root);
        Seeds seeds = root.firstChild("seeds").map(this::readSeeds).orElse(Seeds.DEFAULT);
        root.children().forEach(this::readFactor);
        checkColumns(root);
        AttributeConflicts.report(WorldSource.kinds(worlds), constants, factors, problems);
        checkSize(root, worlds, seeds);
        return problems.isEmpty()
                ? Optional.of(new CampaignPlan(
                        name,
                        header,
                        new PlanFiles(name, bytes, scenarios),
                        new PlanWorlds(worlds),
                        seeds,
                        constants,
                        factors))
                : Optional.empty();
    }

    private PlanHeader readHeader(XmlElement root) {
        AttributeReader fields = new AttributeReader(root, problems);
        PlanHeader header = new PlanHeader(
                fields.text("name", ScenarioLimits.MAX_NAME_LENGTH).orElse(""),
                root.firstChild("description")
                        .map(node -> ElementRules.readText(node, problems).strip())
                        .orElse(""),
                fields.integer("seed", Long.MIN_VALUE, Long.MAX_VALUE, 1),
                fields.choice("sampling", SWITCH, latin -> latin ? "latin" : "random", false),
                fields.choice("end", SWITCH, atVerdict -> atVerdict ? "verdict" : "duration", false));
        fields.reportUnknownAndMissing();
        return header;
    }

    private Seeds readSeeds(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        Seeds seeds = new Seeds(fields.integer("first", -CampaignPlan.MAX_SEED, CampaignPlan.MAX_SEED, 1), (int)
                fields.integer("count", 1, CampaignPlan.MAX_RUNS, 1));
        fields.reportUnknownAndMissing();
        return seeds;
    }

    private void readFactor(XmlElement node) {
        FactorReader reader = new FactorReader(problems);
        switch (node.name()) {
            case "set" -> addSet(node, reader);
            case "variants" -> reader.readVariants(node).ifPresent(factors::add);
            case "faults" -> new FaultsReader(problems).read(node).ifPresent(factors::add);
            case "masks" -> reader.readMasks(node).ifPresent(factors::add);
            default -> {
                // Not a factor.
            }
        }
    }

    /** Adds a set of values; a single fixed value is not a factor. */
    private void addSet(XmlElement node, FactorReader reader) {
        reader.readSet(node).ifPresent(factor -> {
            Factor.Level first = factor.levels().get(0);
            boolean constant = factor.levels().size() == 1 && first.cells().get(0) instanceof AttributeValue.FixedValue;
            if (constant) {
                constants.addAll(first.edits());
            } else {
                factors.add(factor);
            }
        });
    }

    private void checkColumns(XmlElement root) {
        Set<String> names = new HashSet<>(CampaignPlan.RESERVED_COLUMNS);
        for (Factor factor : factors) {
            for (Column column : factor.columns()) {
                if (!names.add(column.name())) {
                    problems.add(root, PlanProblem.DUPLICATE_COLUMN.with(MessageText.excerpt(column.name())));
                }
            }
        }
    }

    private void checkSize(XmlElement root, List<WorldSource> worlds, Seeds seeds) {
        double runs = seeds.count();
        runs *= worlds.stream().mapToDouble(WorldSource::count).sum();
        for (Factor factor : factors) {
            runs *= factor.levels().size();
        }
        reportTooMany(root, runs, problems);
    }

    /** Reports a number of runs that is too large, and returns whether it is. */
    static boolean reportTooMany(XmlElement node, double runs, Problems problems) {
        if (runs > CampaignPlan.MAX_RUNS) {
            problems.add(
                    node,
                    PlanProblem.TOO_MANY_RUNS.with(String.format(Locale.ROOT, "%.0f", runs), CampaignPlan.MAX_RUNS));
        }
        return runs > CampaignPlan.MAX_RUNS;
    }
}
