package faultline.external;

import faultline.control.Decision;
import faultline.control.Observation;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.io.JsonWriter;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Map;
import java.util.function.BooleanSupplier;

/**
 * A simulation that another program steps: {@code reset} begins a run, {@code drive} executes some ticks, and each is
 * answered by one {@code observe}, or by one {@code end} that also carries the last readings.
 */
public final class SimulationServer {

    private static final long MAX_TICKS = 1_000_000_000;
    private static final long TICKS_BETWEEN_CLOCK_READINGS = 100;
    private static final long NANOS_BETWEEN_QUESTIONS = 500_000_000;

    private final String program;
    private final String scenario;
    private final boolean givesTruth;
    private final RequestLines requests;
    private final OutputStream out;
    /** The robot that the client has last received. */
    private RobotSpec knownRobot;

    /**
     * Creates a server.
     *
     * @param program the name and version of the simulator
     * @param scenario the name of the scenario
     * @param givesTruth whether observations carry the ground truth
     * @param in the stream of requests
     * @param out the stream for answers
     */
    public SimulationServer(String program, String scenario, boolean givesTruth, InputStream in, OutputStream out) {
        this.program = program;
        this.scenario = scenario;
        this.givesTruth = givesTruth;
        this.requests = new RequestLines(in);
        this.out = out;
    }

    /** One run and its controller. */
    private static final class Episode implements AutoCloseable {
        private final DriveTelemetry telemetry = new DriveTelemetry("EXTERN");
        /** The decision that was last received, null before the first. */
        private Decision decision;

        private final Simulation simulation;

        Episode(SimulationSetup setup) {
            simulation = new Simulation(setup, observation -> decision, ControllerMode.DIRECT, CommandListener.NONE);
        }

        /** Makes ticks until enough are made or the run is over. Returns false early if nobody waits for them. */
        boolean drive(DriveMessage drive, long ticks, BooleanSupplier isAbandoned) {
            decision = telemetry.decide(drive, simulation.ticks());
            long asked = System.nanoTime();
            for (long i = 0; i < ticks && !isOver(); i++) {
                simulation.tick();
                if (i % TICKS_BETWEEN_CLOCK_READINGS == 0 && System.nanoTime() - asked > NANOS_BETWEEN_QUESTIONS) {
                    if (isAbandoned.getAsBoolean()) {
                        return false;
                    }
                    asked = System.nanoTime();
                }
            }
            return true;
        }

        boolean isOver() {
            return simulation.ticks() >= simulation.setup().ticks();
        }

        Observation observation() {
            double[] readings = new double[simulation.robot().sensors().size()];
            for (int i = 0; i < readings.length; i++) {
                readings[i] = simulation.reportedReading(i);
            }
            return new Observation(simulation.ticks(), simulation.setup().dt(), robot(), readings);
        }

        /** Returns the robot as a controller believes it to be. */
        RobotSpec robot() {
            return simulation.robot().believed();
        }

        @Override
        public void close() {
            simulation.close();
        }
    }

    /**
     * Answers requests until {@code close}, the end of the input, or the failure of a print stream for the answers.
     *
     * @param setup the run that each reset begins
     * @param isClientGone tells during a long step whether nobody can read its answer if the input has ended, too; the
     *     server then ends
     * @throws IOException if the streams cannot be read or written
     * @throws RunFailedException if a request violates the protocol
     */
    public void run(SimulationSetup setup, BooleanSupplier isClientGone) throws IOException {
        knownRobot = setup.robot().believed();
        if (!send(ProtocolMessages.hello(RunDescription.of(program, scenario, setup, 1)))) {
            return;
        }
        Episode episode = new Episode(setup);
        try {
            for (String line = requests.read(); line != null; line = requests.read()) {
                MessageReader request = MessageReader.of(line);
                String type = request.string("type");
                switch (type) {
                    case "close" -> {
                        return;
                    }
                    case "reset" -> {
                        episode.close();
                        episode = new Episode(request.has("seed") ? setup.withSeed(request.whole("seed")) : setup);
                    }
                    case "drive" -> {
                        if (!drive(episode, request, () -> isClientGone.getAsBoolean() && requests.isEnded())) {
                            return;
                        }
                    }
                    default ->
                        throw new ProtocolException(
                                "wrote a message",
                                " of type " + MessageText.quoted(type) + "; expected reset, drive or close");
                }
                if (!send(answer(episode))) {
                    return;
                }
            }
        } catch (ProtocolException e) {
            Message when = ControllerProblem.AT_TICK.with(episode.simulation.ticks());
            throw new RunFailedException(e.sentence("the client", when), e);
        } finally {
            episode.close();
        }
    }

    /** Executes a request; returns false if nobody waits for the answer. */
    private static boolean drive(Episode episode, MessageReader request, BooleanSupplier isAbandoned)
            throws ProtocolException {
        if (episode.isOver()) {
            throw new ProtocolException("wrote a drive message", " after the end of the run; expected reset or close");
        }
        if (request.has("tick") && request.whole("tick") != episode.simulation.ticks()) {
            throw new ProtocolException(ControllerProblem.TICK, request.whole("tick"));
        }
        long ticks = request.has("ticks") ? request.whole("ticks", 1, MAX_TICKS) : 1;
        return episode.drive(DriveMessage.read(request, episode.robot()), ticks, isAbandoned);
    }

    private String answer(Episode episode) {
        Observation observation = episode.observation();
        boolean robotChanged = !observation.robot().equals(knownRobot);
        knownRobot = observation.robot();
        JsonWriter json;
        if (episode.isOver()) {
            String hash = HexFormat.of().toHexDigits(episode.simulation.trajectoryHash());
            json = ProtocolMessages.end("duration", hash, Map.of(), givesTruth);
            ProtocolMessages.writeReadings(json, observation, robotChanged);
        } else {
            json = ProtocolMessages.observe(observation, robotChanged);
        }
        if (givesTruth) {
            ProtocolMessages.writeTruth(json, episode.simulation);
        }
        return json.finish();
    }

    /** Writes a line. Returns whether it was written, because a print stream only notes that it was not. */
    private boolean send(String line) throws IOException {
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
        return !(out instanceof PrintStream noting) || !noting.checkError();
    }
}
