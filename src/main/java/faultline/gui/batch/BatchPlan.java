package faultline.gui.batch;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.ValueSyntax;
import faultline.io.AtomicFile;
import faultline.io.AtomicFileGroup;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.io.XmlText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * A batch as a campaign plan of one scenario. Immutable; files may be written on any thread.
 *
 * @param scenario the scenario of all runs
 * @param firstSeed the seed of the first block of runs
 * @param seeds the number of consecutive seeds
 * @param duration the duration of each run, seconds
 * @param untilVerdict whether a run ends as soon as it is known whether the robot carries on
 * @param diagnosis whether the controller watches its sensors
 * @param healthy whether there are runs without a fault
 * @param faults the kinds of fault with their numbers
 * @param onset when a fault begins, in the syntax of plans
 * @param sensors the ids of the sensors that fail, one in each run
 */
record BatchPlan(
        Scenario scenario,
        long firstSeed,
        int seeds,
        double duration,
        boolean untilVerdict,
        DiagnosisChoice diagnosis,
        boolean healthy,
        List<FaultValues> faults,
        String onset,
        List<String> sensors) {

    BatchPlan {
        faults = List.copyOf(faults);
        sensors = List.copyOf(sensors);
    }

    /** A kind of fault by its name in files, and its number in the syntax of plans; empty for a kind without one. */
    record FaultValues(String kind, String value) {}

    /**
     * Returns how many runs there are, at most {@link Long#MAX_VALUE}; empty if a number is not in the syntax of plans.
     */
    OptionalLong runCount() {
        OptionalInt onsets = ValueSyntax.count(onset);
        // Exact for all numbers of runs that a plan may have.
        double perSensor = 0;
        for (FaultValues fault : faults) {
            OptionalInt values = fault.value().isEmpty() ? OptionalInt.of(1) : ValueSyntax.count(fault.value());
            if (values.isEmpty() || onsets.isEmpty()) {
                return OptionalLong.empty();
            }
            perSensor += (double) values.getAsInt() * onsets.getAsInt();
        }
        double faulty = perSensor * sensors.size();
        double cells = faulty == 0 ? 1 : faulty + (healthy ? 1 : 0);
        return OptionalLong.of((long) (cells * seeds * (diagnosis == DiagnosisChoice.BOTH ? 2 : 1)));
    }

    /** Returns whether a fault may begin at the end of its run or later, so that it has no effect. */
    boolean hasLateFaults() {
        return !faults.isEmpty()
                && !sensors.isEmpty()
                && ValueSyntax.greatest(onset).orElse(0) >= duration;
    }

    /** Returns the text of the plan, given the name of the scenario's file beside it. */
    String text(String scenarioFile) {
        StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        String name = scenario.name().isEmpty() ? "Batch" : "Batch of " + scenario.name();
        String limited = MessageText.start(name, ScenarioLimits.MAX_NAME_LENGTH);
        out.append("<campaign xmlns=\"urn:faultline:campaign:1\"" + attribute("name", limited)
                + (untilVerdict ? " end=\"verdict\"" : "") + ">\n");
        out.append("  <worlds>\n    <scenario" + attribute("file", scenarioFile) + attribute("name", worldName())
                + "/>\n  </worlds>\n");
        out.append("  <seeds first=\"" + firstSeed + "\" count=\"" + seeds + "\"/>\n");
        if (duration != scenario.setup().duration()) {
            out.append("  <set attribute=\"@duration\"" + attribute("value", DecimalText.format(duration)) + "/>\n");
        }
        if (diagnosis != DiagnosisChoice.SCENARIO) {
            out.append("  <set attribute=\"controller/@diagnosis\"" + attribute("value", diagnosis.setting()) + "/>\n");
        }
        return out + faultsText() + "</campaign>\n";
    }

    private String worldName() {
        return scenario.name().isEmpty() ? "scenario" : scenario.name();
    }

    private String faultsText() {
        boolean faulty = !faults.isEmpty() && !sensors.isEmpty();
        if (!faulty) {
            return "";
        }
        StringBuilder out = new StringBuilder("  <faults>\n" + (healthy ? "    <healthy/>\n" : ""));
        for (FaultValues fault : faults) {
            out.append("    <fault" + attribute("kind", fault.kind())
                    + (fault.value().isEmpty() ? "" : attribute("value", fault.value())) + attribute("at", onset)
                    + attribute("sensor", ValueSyntax.formatIds(sensors)) + "/>\n");
        }
        return out + "  </faults>\n";
    }

    private static String attribute(String name, String value) {
        return " " + name + "=\"" + XmlText.escapeAttribute(value) + "\"";
    }

    /**
     * Writes the plan, and the scenario beside it under a name that belongs to no other file: {@code study.xml} and
     * {@code study-scenario.xml}.
     *
     * @throws IOException if a file cannot be written, or the scenario is beyond the limits of the format
     */
    void save(Path file) throws IOException {
        byte[] bytes = scenario.toBytes();
        Path beside = scenarioFile(file, bytes);
        try (AtomicFileGroup files = new AtomicFileGroup()) {
            files.write(beside, bytes);
            files.write(file, text(beside.getFileName().toString()).getBytes(StandardCharsets.UTF_8));
            files.commit();
        }
    }

    private static Path scenarioFile(Path plan, byte[] bytes) throws IOException {
        String stem = plan.getFileName().toString().replaceFirst("\\.xml$", "") + "-scenario";
        Path file = plan.resolveSibling(stem + ".xml");
        for (int number = 2; Files.exists(file) && !Arrays.equals(Files.readAllBytes(file), bytes); number++) {
            file = plan.resolveSibling(stem + "-" + number + ".xml");
        }
        return file;
    }

    /**
     * Writes the plan and the scenario to an empty folder and reads them as the command {@code campaign} does. The
     * scenario has the name that a campaign gives its copy, so that the copy of the plan can be run too.
     *
     * @throws ScenarioException with everything that is wrong with the plan
     * @throws IOException if a file cannot be written, or the scenario is beyond the limits of the format
     */
    CampaignPlan prepare(Path folder) throws IOException, ScenarioException {
        Path file = folder.resolve("plan.xml");
        AtomicFile.write(folder.resolve(PlanFiles.copyName(1)), scenario.toBytes());
        AtomicFile.write(file, text(PlanFiles.copyName(1)).getBytes(StandardCharsets.UTF_8));
        return PlanFiles.read(file);
    }
}
