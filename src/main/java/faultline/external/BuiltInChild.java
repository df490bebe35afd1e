package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.engine.ControllerFactory;
import faultline.engine.RunFailedException;
import faultline.io.DecimalText;
import faultline.io.JsonWriter;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ScenarioLimits;
import faultline.sensor.Reading;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * A built-in controller that runs as the child of another simulator: the counterpart of {@link ExternalController}. Its
 * trajectories equal those of the controller called directly, which shows that the protocol loses no information.
 */
public final class BuiltInChild {

    /** The ticks from one observation to the next; controllers integrate their motion over each of them. */
    private static final long MAX_STEP = 10_000_000;

    /** The greatest absolute value of a reading, metres; even one with a fault is far below it. */
    private static final double MAX_READING = 1e9;

    private final InputStream in;
    private final LineBuffer lines = new LineBuffer();
    private final OutputStream out;
    /** The message that has begun another run, until that run reads it; otherwise null. */
    private String nextHello;

    /**
     * Creates a child.
     *
     * @param in the stream of messages
     * @param out the stream for answers
     */
    public BuiltInChild(InputStream in, OutputStream out) {
        this.in = in;
        this.out = out;
    }

    /**
     * Answers until the end of a run or of the input. Each {@code hello} begins a run with a new controller; that of
     * the run before is closed if it can be closed.
     *
     * @param spec the controller
     * @throws IOException if a message cannot be read or written
     * @throws RunFailedException if the simulator violates the protocol, or the controller throws an exception
     */
    public void run(ControllerSpec spec) throws IOException {
        try {
            do {
                answerRun(spec);
            } while (nextHello != null);
        } catch (ProtocolException e) {
            throw new RunFailedException("the simulator " + e.getMessage(), e);
        }
    }

    private void answerRun(ControllerSpec spec) throws IOException, ProtocolException {
        Controller controller = ControllerFactory.create(spec);
        Closeable closing = () -> ControllerFactory.close(controller, spec);
        try (closing) {
            answerAll(controller, ControllerNames.typeOf(spec));
        }
    }

    private String readLine() throws IOException, ProtocolException {
        String line = nextHello == null ? lines.read(in) : nextHello;
        nextHello = null;
        return line;
    }

    private void answerAll(Controller controller, String name) throws IOException, ProtocolException {
        RobotSpec robot = null;
        double dt = 0;
        long next = 0;
        for (String line = readLine(); line != null; line = readLine()) {
            MessageReader message = MessageReader.of(line);
            String type = message.string("type");
            if (type.equals("end")) {
                return;
            }
            if (!type.equals("hello") && !type.equals("observe")) {
                throw new ProtocolException(
                        "wrote a message", " of type " + MessageText.quoted(type) + "; expected hello, observe or end");
            }
            if (type.equals("hello") && robot != null) {
                nextHello = line;
                return;
            }
            if (type.equals("hello")) {
                dt = checkHello(message);
            }
            if (message.has("robot")) {
                robot = ProtocolMessages.readRobot(message.object("robot"));
            }
            if (type.equals("hello")) {
                send(new JsonWriter()
                        .member("type", "ready")
                        .member("protocol", ProtocolMessages.PROTOCOL)
                        .member("name", name));
            } else {
                Observation observation = observation(message, next, dt, robot);
                next = observation.tick() + 1;
                send(answer(decide(controller, observation), observation.tick()));
            }
        }
    }

    private static Decision decide(Controller controller, Observation observation) {
        try {
            return controller.decide(observation);
        } catch (RuntimeException | Error broken) {
            throw RunFailedException.ofController(observation.tick(), broken);
        }
    }

    /** Returns the length of a tick, seconds. */
    private static double checkHello(MessageReader hello) throws ProtocolException {
        if (hello.whole("protocol") != ProtocolMessages.PROTOCOL) {
            throw new ProtocolException(
                    "speaks protocol " + hello.whole("protocol"), "; expected " + ProtocolMessages.PROTOCOL);
        }
        hello.object("robot");
        double dt = hello.number("dt_s");
        if (dt <= 0) {
            throw new ProtocolException("has ticks of " + DecimalText.format(dt) + " s", "; expected more than 0");
        }
        if (dt < ScenarioLimits.MIN_TICK || dt > ScenarioLimits.MAX_TICK) {
            throw new ProtocolException(
                    "has ticks of " + DecimalText.format(dt) + " s", "; expected " + NumberRange.TICK.rule());
        }
        return dt;
    }

    /** Reads an observation, given the least tick that it may have. */
    private static Observation observation(MessageReader message, long next, double dt, RobotSpec robot)
            throws ProtocolException {
        if (dt == 0) {
            throw new ProtocolException("wrote an observe message", " before the hello message");
        }
        return new Observation(
                message.whole("tick", next, next + MAX_STEP),
                dt,
                robot,
                readings(message, robot.sensors().size()));
    }

    private static double[] readings(MessageReader message, int sensors) throws ProtocolException {
        double[] readings = message.numbers("readings_m", Reading.NOTHING);
        boolean[] answers = message.flags("answers");
        if (readings.length != sensors || answers.length != sensors) {
            throw new ProtocolException(
                    "wrote an observe message",
                    " with " + readings.length + " readings and " + answers.length + " answers; expected " + sensors
                            + " of each, one for each sensor");
        }
        for (int i = 0; i < readings.length; i++) {
            if (Double.isFinite(readings[i]) && Math.abs(readings[i]) > MAX_READING) {
                throw new ProtocolException(
                        "wrote an observe message",
                        " with a reading of " + DecimalText.format(readings[i]) + " m; expected from "
                                + DecimalText.format(-MAX_READING) + " to " + DecimalText.format(MAX_READING));
            }
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
