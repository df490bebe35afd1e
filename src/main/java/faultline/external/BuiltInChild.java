package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.engine.ControllerFactory;
import faultline.io.JsonWriter;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * A built-in controller that runs as the child of another simulator: the counterpart of {@link ExternalController}. Its
 * trajectories equal those of the controller called directly, which shows that the protocol loses no information.
 */
public final class BuiltInChild {

    private final BufferedReader in;
    private final OutputStream out;

    /**
     * Creates a child.
     *
     * @param in the stream of messages
     * @param out the stream for answers
     */
    public BuiltInChild(InputStream in, OutputStream out) {
        this.in = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
        this.out = out;
    }

    /**
     * Answers until the end of the run or of the input.
     *
     * @param spec the controller
     * @throws IOException if a message cannot be read or written
     */
    public void run(ControllerSpec spec) throws IOException {
        try {
            Controller controller = ControllerFactory.create(spec);
            RobotSpec robot = null;
            double dt = 0;
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                MessageReader message = MessageReader.of(line);
                String type = message.string("type");
                if (type.equals("end")) {
                    return;
                }
                if (message.has("robot")) {
                    robot = ProtocolMessages.readRobot(message.object("robot"));
                }
                if (type.equals("hello")) {
                    dt = message.number("dt_s");
                    send(new JsonWriter()
                            .member("type", "ready")
                            .member("protocol", ProtocolMessages.PROTOCOL)
                            .member("name", ControllerFactory.initialState(spec).name()));
                } else if (type.equals("observe")) {
                    Observation observation = new Observation(message.whole("tick"), dt, robot, readings(message));
                    send(answer(controller.decide(observation), observation.tick()));
                }
            }
        } catch (ProtocolException e) {
            throw new IOException("the simulator " + e.getMessage(), e);
        }
    }

    private static double[] readings(MessageReader message) throws ProtocolException {
        double[] readings = message.numbers("readings_m", Reading.NOTHING);
        boolean[] answers = message.flags("answers");
        for (int i = 0; i < readings.length; i++) {
            readings[i] = answers[i] ? readings[i] : Reading.OFF;
        }
        return readings;
    }

    private static JsonWriter answer(Decision decision, long tick) {
        return new JsonWriter()
                .member("type", "drive")
                .member("tick", tick)
                .member("left_v", decision.leftVolts())
                .member("right_v", decision.rightVolts())
                .member("state", decision.telemetry().state().name())
                .member("why", decision.telemetry().condition());
    }

    private void send(JsonWriter message) throws IOException {
        out.write((message.finish() + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
    }
}
