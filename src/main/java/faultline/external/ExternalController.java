package faultline.external;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.engine.RunFailedException;
import faultline.engine.RunProblem;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.io.JsonWriter;
import faultline.io.Message;
import faultline.io.MessageException;
import faultline.io.MessageText;
import faultline.io.XmlText;
import faultline.robot.RobotSpec;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/**
 * A controller in a child process, called in lock-step by the simulation thread. If the child violates the protocol or
 * exceeds a time limit, the run ends with a {@link RunFailedException}; no decision replaces the missing one.
 */
public final class ExternalController implements Controller, TickObserver, AutoCloseable {

    /**
     * The time limits for a child. A time-out ends a run; it never changes its results.
     *
     * @param ready the limit until it is ready, seconds, positive; infinity for no limit
     * @param answer the limit for each answer, seconds, positive; infinity for no limit
     */
    public record Timeouts(double ready, double answer) {

        /** The limits of the protocol. */
        public static final Timeouts DEFAULT = new Timeouts(30, 10);

        /**
         * Creates limits.
         *
         * @param ready the limit until it is ready, seconds, positive; infinity for no limit
         * @param answer the limit for each answer, seconds, positive; infinity for no limit
         * @throws IllegalArgumentException if a limit is not positive
         */
        public Timeouts {
            if (!(ready > 0 && answer > 0)) {
                throw new IllegalArgumentException("time limits must be positive: " + ready + ", " + answer);
            }
        }

        /**
         * {@return these limits with another limit for answers, which is also the minimum of the limit for the start}
         *
         * @param seconds the limit for each answer, in seconds, positive; infinity for no limit
         */
        public Timeouts withAnswer(double seconds) {
            return new Timeouts(Math.max(ready, seconds), seconds);
        }
    }

    /** The state of a child without a name until it names one. */
    private static final String NAMELESS_STATE = "EXTERN";

    /** A line of a traceback that only marks a part of the line above it, or the border of a group of exceptions. */
    private static final Pattern MARKS = Pattern.compile("[ |~^]*| *\\+-[-+ 0-9]*");

    private final Message who;
    private final ChildProcess child;
    private final Timeouts timeouts;
    private final boolean givesTruth;
    private final String name;
    private final DriveTelemetry telemetry;
    private RobotSpec knownRobot;
    private Simulation simulation;
    /** The tick of the last observation, or -1 before the first. */
    private long lastTick = -1;

    /**
     * Starts a child and waits until it is ready.
     *
     * @param command the command line
     * @param run the description that the child receives first
     * @param timeouts the time limits for the child
     * @param givesTruth whether observations carry the ground truth
     * @param errors the consumer of each line of the child's standard error, called on a separate thread
     * @throws RunFailedException if the child cannot be started or does not become ready
     */
    public ExternalController(
            String command, RunDescription run, Timeouts timeouts, boolean givesTruth, Consumer<String> errors) {
        this.who = ControllerProblem.CONTROLLER.with(command);
        this.timeouts = timeouts;
        this.givesTruth = givesTruth;
        this.knownRobot = run.conditions().robot();
        this.child = start(command, timeouts.answer(), errors);
        this.name = greet(run);
        this.telemetry = new DriveTelemetry(name.isEmpty() ? NAMELESS_STATE : name);
    }

    private ChildProcess start(String command, double writeSeconds, Consumer<String> errors) {
        try {
            List<String> words = ShellWords.split(command);
            if (words.isEmpty()) {
                throw new MessageException("", ControllerProblem.EMPTY_COMMAND.with(), null);
            }
            return startChild(words, writeSeconds, errors);
        } catch (IOException | IllegalArgumentException e) {
            throw new ControllerStartException(
                    ControllerProblem.NOT_STARTED.with(who, reason(e), ControllerNames.hint(command)), e);
        }
    }

    private static Object reason(Exception failure) {
        if (failure instanceof IllegalArgumentException) {
            return ControllerProblem.OPEN_QUOTE.with();
        }
        return failure instanceof MessageException known ? known.reason() : String.valueOf(failure.getMessage());
    }

    private static ChildProcess startChild(List<String> words, double writeSeconds, Consumer<String> errors)
            throws IOException {
        try {
            return new ChildProcess(words, writeSeconds, errors);
        } catch (IOException e) {
            throw new MessageException("", StartFailure.describe(words.get(0), e.getMessage()), e);
        }
    }

    /** Greets the child, and returns the name that it gives itself; empty if it gives none. */
    private String greet(RunDescription run) {
        try {
            child.send(ProtocolMessages.hello(run));
            MessageReader ready = receive("ready", timeouts.ready());
            if (ready.whole("protocol") != ProtocolMessages.PROTOCOL) {
                throw new ProtocolException(
                        ControllerProblem.PROTOCOL, ready.whole("protocol"), ProtocolMessages.PROTOCOL);
            }
            return XmlText.oneLine(MessageText.name(ready.string("name", "")));
        } catch (ProtocolException | IOException e) {
            throw failure(e, ControllerProblem.BEFORE_START.with());
        }
    }

    private MessageReader receive(String type, double seconds) throws IOException, ProtocolException {
        MessageReader message = MessageReader.of(child.receive(seconds));
        String given = message.string("type");
        if (!given.equals(type)) {
            throw new ProtocolException(ControllerProblem.TYPE, MessageText.quoted(given), type);
        }
        return message;
    }

    @Override
    public Decision decide(Observation observation) {
        boolean robotChanged = !observation.robot().equals(knownRobot);
        knownRobot = observation.robot();
        lastTick = observation.tick();
        JsonWriter json = ProtocolMessages.observe(observation, robotChanged);
        if (givesTruth && simulation != null) {
            ProtocolMessages.writeTruth(json, simulation);
        }
        try {
            boolean early = child.hasLine();
            if (!early) {
                child.send(json.finish());
            }
            MessageReader drive = receive("drive", timeouts.answer());
            if (drive.whole("tick") != observation.tick()) {
                throw new ProtocolException(ControllerProblem.TICK, drive.whole("tick"));
            }
            if (early) {
                throw new ProtocolException(ControllerProblem.EARLY_ANSWER);
            }
            return telemetry.decide(DriveMessage.read(drive, observation.robot()), observation.tick());
        } catch (InterruptedIOException ended) {
            child.close();
            throw new RunFailedException(RunProblem.INTERRUPTED.with(observation.tick()), ended);
        } catch (ProtocolException | IOException e) {
            throw failure(e, ControllerProblem.AT_TICK.with(observation.tick()));
        }
    }

    @Override
    public String name() {
        return name;
    }

    /** Stores the simulation, whose truth is sent with the next observation if this is enabled. */
    @Override
    public void observe(Simulation observed) {
        simulation = observed;
    }

    private RunFailedException failure(Exception cause, Message when) {
        child.close();
        if (child.isEndedWithProgram()) {
            return new RunFailedException(ControllerProblem.ENDED_WITH_PROGRAM.with(who, when), cause);
        }
        Message sentence = cause instanceof ProtocolException broken
                ? broken.sentence(who, when)
                : ControllerProblem.UNREADABLE.with(who, when, String.valueOf(cause.getMessage()));
        return new RunFailedException(withStandardError(sentence, child.lastErrorLines()), cause);
    }

    /**
     * Adds what a child wrote to a sentence, the last line first: a traceback ends with the reason, and a message may
     * be cut off.
     */
    private static Message withStandardError(Message sentence, List<String> lines) {
        List<String> words =
                lines.stream().filter(line -> !MARKS.matcher(line).matches()).toList();
        if (words.isEmpty()) {
            return sentence;
        }
        int last = words.size() - 1;
        return last == 0
                ? ControllerProblem.LAST_LINE.with(sentence, words.get(last))
                : ControllerProblem.LAST_LINES.with(
                        sentence, withException(words), String.join(" | ", words.subList(0, last)));
    }

    /**
     * Returns the last of several lines. If it is no exception, but follows one, such as a further line of its message,
     * the exception is added.
     */
    private static Object withException(List<String> lines) {
        String last = lines.get(lines.size() - 1);
        List<String> traceback = PythonTraceback.beginning(lines);
        return traceback.isEmpty() || traceback.size() == lines.size()
                ? withOwnLine(last, lines)
                : ControllerProblem.AFTER_EXCEPTION.with(
                        PythonTraceback.withoutMargin(last),
                        withOwnLine(traceback.get(traceback.size() - 1), traceback));
    }

    /** Adds the line of the user's program to the reason of a traceback. */
    private static Object withOwnLine(String reason, List<String> lines) {
        return PythonTraceback.findOwnLine(lines)
                .<Object>map(place -> ControllerProblem.AT_LINE.with(reason, place.file(), place.line()))
                .orElse(reason);
    }

    /**
     * Informs the child that the run has ended, and closes it. What the child does after the end has no effect, unless
     * it answers the last observation again. An answer to the end has another tick or none.
     *
     * @param reason the reason for the end, such as {@code duration}
     * @param trajectoryHash the trajectory hash of the whole run
     * @param summary the lines of the run's summary
     * @throws RunFailedException if there is a further answer to the last observation
     */
    public void finish(String reason, String trajectoryHash, Map<String, String> summary) {
        try {
            child.send(ProtocolMessages.end(reason, trajectoryHash, summary, givesTruth)
                    .finish());
        } catch (ProtocolException gone) {
            // A child that has already ended needs no message.
        }
        if (child.closeAndFind(this::isLastAnswer)) {
            ProtocolException extra = new ProtocolException(ControllerProblem.EXTRA_ANSWER);
            throw new RunFailedException(extra.sentence(who, ""), extra);
        }
    }

    private boolean isLastAnswer(String line) {
        try {
            MessageReader message = MessageReader.of(line);
            return message.string("type").equals("drive") && message.whole("tick") == lastTick;
        } catch (ProtocolException other) {
            return false;
        }
    }

    @Override
    public void close() {
        child.close();
    }
}
