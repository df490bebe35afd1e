package faultline.scenario;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.Expectation.ConditionCases;
import faultline.io.AtomicFile;
import faultline.io.DecimalText;
import faultline.io.MessageException;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import faultline.scenario.xml.XmlFile;
import faultline.scenario.xml.XmlFormat;
import faultline.scenario.xml.XmlWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Writes a scenario as a file that reads back to an equal scenario. */
final class ScenarioWriter {

    private ScenarioWriter() {}

    /** Writes a scenario file with the comments that a person has put into it, completely or not at all. */
    static void write(Scenario scenario, Path file, XmlComments comments) throws IOException {
        AtomicFile.write(file, toBytes(scenario, comments));
    }

    /** Returns the bytes of a scenario file. It is checked that reading them gives the same scenario. */
    static byte[] toBytes(Scenario scenario, XmlComments comments) throws IOException {
        byte[] bytes = toText(scenario, comments).getBytes(StandardCharsets.UTF_8);
        try {
            XmlFile.checkSize("", bytes.length);
            if (!ScenarioReader.read("", bytes).equals(scenario)) {
                throw new MessageException("", ProblemKind.NOT_SAVED.with(ProblemKind.NOT_REPRODUCIBLE.with()), null);
            }
        } catch (ScenarioException e) {
            throw new MessageException(
                    "", ProblemKind.NOT_SAVED.with(e.problems().get(0).message()), e);
        }
        return bytes;
    }

    static String toText(Scenario scenario, XmlComments comments) {
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
            out.beginElement("description").endTextElement(scenario.description());
        }
        WorldWriter.write(setup.world(), out);
        RobotWriter.write(setup.robot(), setup.start(), out);
        ControllerWriter.write(setup.controller(), out);
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
        Map<String, String> attributes = new LinkedHashMap<>();
        ConditionCases<String> cases = new ConditionCases<>(
                collides -> attributes.put("collision", Boolean.toString(collides.wanted())),
                coverage -> attributes.put("minCoverage", DecimalText.format(coverage.share())),
                distance -> attributes.put("maxDistanceRms", DecimalText.format(distance.metres())),
                visited -> attributes.merge("states", visited.state().name(), (all, next) -> all + " " + next),
                last -> attributes.put("finalState", last.state().name()));
        expect.conditions().forEach(condition -> condition.match(cases));
        out.beginElement("expect");
        attributes.forEach(out::attribute);
        out.endElement();
    }
}
