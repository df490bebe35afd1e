package faultline.scenario.xml;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.io.AtomicFile;
import faultline.io.DecimalText;
import faultline.io.MessageException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Writes a scenario as a file that reads back to an equal scenario. */
public final class ScenarioWriter {

    private ScenarioWriter() {}

    /**
     * Writes a scenario file, completely or not at all.
     *
     * @param scenario the content; it is checked that reading the file gives the same content
     * @param file the file; an existing one is replaced
     * @param comments the comments that a person has put into the file
     * @throws IOException if the file cannot be written, or the content is beyond the limits of the format
     */
    public static void write(ScenarioContent scenario, Path file, XmlComments comments) throws IOException {
        AtomicFile.write(file, toBytes(scenario, comments));
    }

    /**
     * {@return the bytes of a scenario file; it is checked that reading them gives the same scenario}
     *
     * @param scenario the content
     * @param comments the comments that a person has put into the file
     * @throws IOException if the content is beyond the limits of the format
     */
    public static byte[] toBytes(ScenarioContent scenario, XmlComments comments) throws IOException {
        byte[] bytes = toText(scenario, comments).getBytes(StandardCharsets.UTF_8);
        try {
            if (!ScenarioReader.read("", bytes).equals(scenario)) {
                throw new MessageException("", ProblemKind.NOT_SAVED.with(ProblemKind.NOT_REPRODUCIBLE.with()), null);
            }
        } catch (ScenarioException e) {
            throw new MessageException(
                    "", ProblemKind.NOT_SAVED.with(e.problems().get(0).message()), e);
        }
        return bytes;
    }

    static String toText(ScenarioContent scenario, XmlComments comments) {
        SimulationSetup setup = scenario.setup();
        XmlWriter out = new XmlWriter(comments);
        out.beginElement("scenario")
                .attribute("xmlns", XmlFormat.SCENARIO.namespace())
                .attribute("name", scenario.name())
                .attribute("duration", setup.duration())
                .attribute("tick", setup.dt())
                .attribute("seed", String.valueOf(setup.seed()));
        if (scenario.recorded()) {
            out.attribute("recorded", true);
        }
        if (!scenario.description().isEmpty()) {
            out.textElement("description", scenario.description());
        }
        WorldWriter.write(setup.world(), out);
        RobotWriter.write(setup.robot(), setup.start(), out);
        ControllerXml.write(setup.controller(), out);
        if (!setup.timeline().isEmpty()) {
            TimelineWriter.write(setup.timeline(), setup.controller(), out);
        }
        writeExpectation(scenario.expectation(), out);
        return out.endElement().toString();
    }

    private static void writeExpectation(Expectation expect, XmlWriter out) {
        if (expect.equals(Expectation.NONE)) {
            return;
        }
        out.beginElement("expect");
        Map<String, String> attributes = new LinkedHashMap<>();
        for (Expectation.Condition condition : expect.conditions()) {
            if (condition instanceof Expectation.Collides collision) {
                attributes.put("collision", Boolean.toString(collision.wanted()));
            } else if (condition instanceof Expectation.MinCoverage coverage) {
                attributes.put("minCoverage", DecimalText.format(coverage.share()));
            } else if (condition instanceof Expectation.MaxDistanceRms rms) {
                attributes.put("maxDistanceRms", DecimalText.format(rms.metres()));
            } else if (condition instanceof Expectation.VisitedState visited) {
                attributes.merge("states", visited.state().name(), (all, next) -> all + " " + next);
            } else if (condition instanceof Expectation.FinalState last) {
                attributes.put("finalState", last.state().name());
            }
        }
        attributes.forEach(out::attribute);
        out.endElement();
    }
}
