package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.FactorKind;
import faultline.campaign.plan.ValueSyntax;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** The sections on faults: the survival matrix and the delays of detection. */
final class FaultSections {

    private static final String DELAYS_EXPLAINED =
            "Seconds from a fault until the controller distrusts the sensor: the median and the 90 % quantile of the"
                    + " runs in which it does, and their share of the runs with a diagnosis. A fault with little"
                    + " effect need not be detected.";

    /** The column of the delay until a fault is detected. */
    static final String DELAY = "detection_delay_s";

    /** The minimum share of runs in which the robot carries on with a sufficient set of sensors. */
    private static final double SUFFICIENT = 0.85;

    /** The maximum number of cells of a matrix. One of more cells would be hard to read, and most may have no runs. */
    private static final int MAX_CELLS = 10_000;

    private static final String ALL_FAULTS = "all faults";

    private final CampaignRuns campaign;

    FaultSections(CampaignRuns campaign) {
        this.campaign = campaign;
    }

    /** Returns a matrix of faults by sensors for each level of the first compared factor, empty without faults. */
    String matrix() {
        if (campaign.faults().isEmpty()) {
            return "";
        }
        StringBuilder tables = new StringBuilder();
        Optional<String> compared = comparedColumn();
        CampaignRuns.group(campaign.rows(), row -> compared.map(row::text).orElse(""))
                .forEach((level, rows) -> {
                    compared.ifPresent(column -> tables.append("<h3>")
                            .append(Html.escape(column + " " + level))
                            .append("</h3>\n"));
                    List<RunRow> healthy =
                            rows.stream().filter(campaign::isHealthy).toList();
                    tables.append(
                                    healthy.isEmpty()
                                            ? ""
                                            : "<p>Healthy: " + Html.survival(Survival.of(healthy)) + ".</p>\n")
                            .append(tables(rows, runs -> Html.survivalCell(Survival.of(runs))));
                });
        return Html.section(
                "Survival by fault and sensor",
                Html.paragraph("Share of runs in which the robot carried on, with its 95 % interval (Wilson) and the"
                                + " number of runs." + otherFaults() + pooledFactors("cell", FactorKind.FAULTS))
                        + tables);
    }

    /** Returns the column of the first compared factor; empty if no factor is compared. */
    private Optional<String> comparedColumn() {
        return campaign.comparedFactors().stream().map(FaultSections::column).findFirst();
    }

    private static String column(FactorSummary factor) {
        return factor.columns().get(0).name();
    }

    private String otherFaults() {
        return campaign.faults().size() == 1
                ? ""
                : " The plan has several faults in a run, with a table for each of them. The runs of a cell may also"
                        + " have the other faults. Healthy runs have none.";
    }

    /** Returns a table for each element of faults in the plan, of those runs in which its fault acts. */
    private String tables(List<RunRow> rows, Function<List<RunRow>, String> cell) {
        return campaign.faults().stream()
                .map(columns ->
                        table(columns, rows.stream().filter(columns::isFailing).toList(), cell))
                .collect(Collectors.joining());
    }

    /** Returns a table of the runs of each fault and part that fails, of all faults and of all parts. */
    private String table(FaultColumns columns, List<RunRow> faulty, Function<List<RunRow>, String> cell) {
        Set<String> parts = CampaignRuns.group(faulty, columns::failingPart).keySet();
        Map<String, List<RunRow>> lines = new LinkedHashMap<>();
        CampaignRuns.group(faulty, row -> row.text(columns.fault()))
                .forEach((name, group) -> lines.put(Html.escape(name), group));
        String fault = campaign.faults().size() == 1 ? "fault" : Html.escape(columns.fault());
        return (long) lines.size() * parts.size() > MAX_CELLS
                ? list(columns, fault, lines, faulty, cell)
                : matrix(columns, fault, parts, lines, faulty, cell);
    }

    /** Returns a table with a row for each fault and for all of them, and a column for each part that fails. */
    private static String matrix(
            FaultColumns columns,
            String fault,
            Set<String> parts,
            Map<String, List<RunRow>> lines,
            List<RunRow> faulty,
            Function<List<RunRow>, String> cell) {
        List<List<String>> rows = new ArrayList<>();
        BiConsumer<String, List<RunRow>> addLine = (name, group) -> {
            Map<String, List<RunRow>> cells = CampaignRuns.group(group, columns::failingPart);
            List<String> line = new ArrayList<>(List.of(name));
            parts.forEach(each -> line.add(cell.apply(cells.getOrDefault(each, List.of()))));
            line.add(cell.apply(group));
            rows.add(line);
        };
        lines.forEach(addLine);
        addLine.accept(ALL_FAULTS, faulty);
        List<String> header = new ArrayList<>(List.of(fault));
        parts.forEach(each -> header.add(Html.escape(each)));
        header.add("all");
        return Html.table("matrix", header, rows);
    }

    /** Returns a table with a row for each fault and part that runs have. */
    private static String list(
            FaultColumns columns,
            String fault,
            Map<String, List<RunRow>> lines,
            List<RunRow> faulty,
            Function<List<RunRow>, String> cell) {
        List<List<String>> rows = new ArrayList<>();
        BiConsumer<String, List<RunRow>> addLines = (name, group) -> {
            CampaignRuns.group(group, columns::failingPart)
                    .forEach((part, some) -> rows.add(List.of(name, Html.escape(part), cell.apply(some))));
            rows.add(List.of(name, "all", cell.apply(group)));
        };
        lines.forEach(addLines);
        addLines.accept(ALL_FAULTS, faulty);
        return Html.table("matrix", List.of(fault, "part", "runs"), rows);
    }

    /** Returns the delays of detection by fault and part, empty if the runs have none. */
    String delays() {
        if (campaign.faults().isEmpty() || !campaign.has(DELAY)) {
            return "";
        }
        List<RunRow> diagnosed = campaign.rows().stream()
                .filter(row -> !row.text("final_rung").isEmpty() && !campaign.isHealthy(row))
                .toList();
        return Html.section(
                "Detection delays",
                Html.paragraph(DELAYS_EXPLAINED)
                        + tables(diagnosed, FaultSections::delayCell)
                        + ReportCharts.histogram("detection delay (s)", CampaignRuns.values(diagnosed, DELAY)));
    }

    private static String delayCell(List<RunRow> rows) {
        int detected = CampaignRuns.values(rows, DELAY).length;
        if (detected == 0) {
            return "&ndash;";
        }
        return "<b>" + seconds(rows, 0.5) + "</b><small>" + seconds(rows, 0.9) + "</small><small>"
                + Html.percent((double) detected / rows.size()) + "</small>";
    }

    /** Returns a quantile of the delays of runs, of which at least one has a delay. */
    private static String seconds(List<RunRow> rows, double share) {
        double value = LowerQuantile.of(CampaignRuns.values(rows, DELAY), share).orElseThrow();
        return Html.format(value < 10 ? "%.2f" : "%.0f", value);
    }

    /**
     * Returns the smallest sets of sensors with which the robot carries on, for each level of the first compared
     * factor; empty without masks.
     */
    String sensorSets() {
        List<String> masks = campaign.factors(FactorKind.MASKS).stream()
                .map(FaultSections::column)
                .toList();
        if (masks.isEmpty()) {
            return "";
        }
        StringBuilder sections = new StringBuilder();
        Optional<String> compared = comparedColumn();
        CampaignRuns.group(campaign.rows(), row -> compared.map(row::text).orElse(""))
                .forEach((level, rows) -> sections.append(Html.section(
                        "Minimum sets of sensors"
                                + compared.map(column -> ": " + column + " " + level)
                                        .orElse(""),
                        sensorSets(sets(rows, masks)))));
        return sections.toString();
    }

    private String sensorSets(List<SensorSet> sets) {
        String percent = Survival.percentText(SUFFICIENT) + " %";
        return Html.paragraph("A set is sufficient if the robot carries on in at least " + percent
                        + " of its runs, minimal if no smaller set inside it is sufficient. "
                        + count(sets, SensorSet::isSufficient)
                        + " of " + sets.size() + " sets are sufficient. A set is certain if its whole 95 %"
                        + " interval is at " + percent + " or more, which requires " + certainRuns()
                        + " independent runs or more; "
                        + count(sets, SensorSet::isCertain) + " are certain." + pooledFactors("set", FactorKind.MASKS))
                + minimumTable(sets)
                + "<h3>All sets</h3>\n"
                + Html.table(
                        "numbers", List.of("sensors on", "sets", "sufficient", "best set", "carried on"), bySize(sets));
    }

    /** Returns the sets of sensors of some runs. The masks of a run switch different sensors. */
    private static List<SensorSet> sets(List<RunRow> rows, List<String> masks) {
        List<SensorSet> sets = new ArrayList<>();
        Map<String, Integer> numbers = new HashMap<>();
        CampaignRuns.group(rows, row -> masks.stream().map(row::text).toList()).forEach((names, group) -> {
            List<String> ids = names.stream()
                    .flatMap(name -> ValueSyntax.parseSensorSet(name).stream())
                    .toList();
            BitSet sensors = new BitSet();
            for (String id : ids) {
                numbers.putIfAbsent(id, numbers.size());
                sensors.set(numbers.get(id));
            }
            String name = names.size() == 1 ? names.get(0) : ValueSyntax.formatSensorSet(ids);
            sets.add(new SensorSet(name, sensors, Survival.of(group)));
        });
        return sets;
    }

    /**
     * Returns a sentence about the factors of which a part of a table has runs with all levels, given the kind of those
     * that the parts differ in; empty if there are none.
     */
    private String pooledFactors(String part, FactorKind shown) {
        String pooled = campaign.plan().factors().stream()
                .filter(factor -> factor.kind() != shown && factor.levelCount() > 1)
                .map(FaultSections::column)
                .filter(column -> !comparedColumn().equals(Optional.of(column)))
                .collect(Collectors.joining(", "));
        return pooled.isEmpty() ? "" : " The runs of a " + part + " are those with all levels of " + pooled + ".";
    }

    /** Returns the least number of runs of a certain set, if the robot carries on in all of them. */
    private static int certainRuns() {
        return IntStream.iterate(1, runs -> runs + 1)
                .filter(runs -> Interval.wilson(runs, runs).low() >= SUFFICIENT)
                .findFirst()
                .getAsInt();
    }

    /**
     * Sensors that are on: their name in the results, a bit for each of them, and how often the robot carries on with
     * them.
     */
    private record SensorSet(String name, BitSet sensors, Survival survival) {

        /** Those with the greatest shares first, those without decided runs last. */
        static final Comparator<SensorSet> BEST_FIRST = Comparator.comparing((SensorSet set) -> set.survival.n() == 0)
                .thenComparing(set -> -set.survival.share())
                .thenComparing(SensorSet::name);

        boolean isSufficient() {
            return survival.n() > 0 && survival.share() >= SUFFICIENT;
        }

        boolean isCertain() {
            return survival.interval().low() >= SUFFICIENT;
        }

        int size() {
            return sensors.cardinality();
        }
    }

    private static long count(List<SensorSet> sets, Predicate<SensorSet> condition) {
        return sets.stream().filter(condition).count();
    }

    /** Returns the sufficient sets in which no smaller one is, those of fewer sensors first. */
    private static List<SensorSet> minimumSets(List<SensorSet> sets) {
        List<SensorSet> minimum = new ArrayList<>();
        SensorSetIndex smaller = new SensorSetIndex();
        List<SensorSet> sufficient =
                sets.stream().filter(SensorSet::isSufficient).toList();
        new TreeMap<>(CampaignRuns.group(sufficient, SensorSet::size)).forEach((size, some) -> {
            List<SensorSet> found = some.stream()
                    .filter(set -> !smaller.hasSubset(set.sensors()))
                    .sorted(SensorSet.BEST_FIRST)
                    .toList();
            // Different sets of one size never contain each other.
            found.forEach(set -> smaller.add(set.sensors()));
            minimum.addAll(found);
        });
        return minimum;
    }

    private static String minimumTable(List<SensorSet> sets) {
        List<List<String>> rows = minimumSets(sets).stream()
                .map(set -> List.of(
                        Html.escape(set.name()),
                        String.valueOf(set.size()),
                        set.isCertain() ? "yes" : "no",
                        Html.survivalCell(set.survival())))
                .toList();
        return rows.isEmpty()
                ? Html.paragraph("No set is sufficient.")
                : Html.table("numbers", List.of("minimum set", "sensors", "certain", "carried on"), rows);
    }

    private static List<List<String>> bySize(List<SensorSet> sets) {
        List<List<String>> rows = new ArrayList<>();
        new TreeMap<>(CampaignRuns.group(sets, SensorSet::size)).forEach((size, some) -> {
            SensorSet best = Collections.min(some, SensorSet.BEST_FIRST);
            rows.add(List.of(
                    String.valueOf(size),
                    String.valueOf(some.size()),
                    String.valueOf(count(some, SensorSet::isSufficient)),
                    Html.escape(best.name()),
                    Html.survivalCell(best.survival())));
        });
        return rows;
    }
}
