package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.engine.Setup;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** Writes a scenario as a file that reads back to an equal one. */
final class ScenarioWriter {

    private ScenarioWriter() {
    }

    /**
     * The file's bytes.
     *
     * @throws IOException if the scenario holds what no file may, such as a size beyond the limits
     */
    static byte[] toBytes(Scenario scenario, Remarks remarks) throws IOException {
        byte[] bytes = toText(scenario, remarks).getBytes(StandardCharsets.UTF_8);
        try {
            if (!ScenarioReader.read("", bytes).equals(scenario)) {
                throw new IOException("the scenario cannot be saved: it would not read back the same");
            }
        } catch (ScenarioException e) {
            throw new IOException("the scenario cannot be saved: " + e.complaints().get(0).text(), e);
        }
        return bytes;
    }

    static String toText(Scenario scenario, Remarks remarks) {
        Setup setup = scenario.setup();
        XmlOut out = new XmlOut(remarks);
        out.begin("scenario").set("xmlns", ScenarioSchema.NAMESPACE).set("name", scenario.name())
                .set("duration", setup.duration()).set("tick", setup.dt()).set("seed", String.valueOf(setup.seed()));
        if (scenario.recorded()) {
            out.set("recorded", true);
        }
        if (!scenario.description().isEmpty()) {
            out.text("description", scenario.description());
        }
        WorldWriter.world(setup.world(), out);
        RobotWriter.robot(setup.robot(), setup.start(), out);
        controller(setup.controller(), out);
        if (!setup.timeline().isEmpty()) {
            TimelineWriter.timeline(setup.timeline(), out);
        }
        expect(scenario.expect(), out);
        return out.end().toString();
    }

    private static void controller(ControllerSpec spec, XmlOut out) {
        out.begin("controller");
        if (spec instanceof ControllerSpec.WallFollowing follow) {
            out.set("type", "wall-follower").set("distance", follow.distance()).set("hand", follow.hand().fileName())
                    .set("period", follow.period()).set("timing", follow.timing().fileName());
        } else if (spec instanceof ControllerSpec.Drive drive) {
            out.set("type", "drive").set("left", drive.leftVolts()).set("right", drive.rightVolts());
        } else {
            out.set("type", "none");
        }
        out.end();
    }

    private static void expect(Expectation expect, XmlOut out) {
        if (expect.equals(Expectation.NONE)) {
            return;
        }
        out.begin("expect");
        expect.collision().ifPresent(value -> out.set("collision", value));
        expect.minCoverage().ifPresent(value -> out.set("minCoverage", value));
        expect.maxDistanceRms().ifPresent(value -> out.set("maxDistanceRms", value));
        if (!expect.states().isEmpty()) {
            out.set("states", String.join(" ", expect.states()));
        }
        expect.finalState().ifPresent(value -> out.set("finalState", value));
        out.end();
    }
}
