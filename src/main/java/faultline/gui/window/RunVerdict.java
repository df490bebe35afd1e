package faultline.gui.window;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.external.ControllerProblem;
import faultline.gui.text.ContactText;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.ExpectationText;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.io.Message;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.world.Collision;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The end of a run: a collision, with a failure, or at the scenario's duration.
 *
 * @param success whether all expectations hold and there is no collision that is not expected
 * @param title the event, in a few words
 * @param detail why, empty if there is nothing to add
 * @param event the tick of the failure or the collision, 0 if it was at the start, -1 if there is neither
 */
record RunVerdict(boolean success, String title, String detail, long event) {

    /** The time before the event to which the run is moved back, seconds. */
    private static final double LEAD_TIME = 2;

    private static final long NONE = -1;
    /** The greatest number of sensors with the same fault that are named. */
    private static final int MAX_NAMED = 2;
    /** The greatest number of faults that are listed. */
    private static final int MAX_ENTRIES = 8;

    /** Returns the verdict on a run, empty while the run is in progress. */
    static Optional<RunVerdict> of(SessionFrame frame, SessionStatus status, Scenario scenario) {
        if (status.failure().isPresent()) {
            return Optional.of(new RunVerdict(
                    false,
                    Messages.get(
                            "verdict.broken",
                            NumberText.format("%.3f", frame.snapshot().time())),
                    failureText(status.failure().get()),
                    frame.snapshot().tick()));
        }
        List<Expectation.Condition> required = scenario.expectation().conditions();
        boolean ended = !status.running() && isEnd(frame, scenario.setup());
        Optional<Collision> collision = frame.snapshot().collision();
        if (ended) {
            return Optional.of(atEnd(frame, required));
        }
        return collision.map(contact -> atCollision(contact, required));
    }

    /** Returns why a run has failed, with the last line only of those that the controller has printed. */
    private static String failureText(Message reason) {
        if (reason.template() != ControllerProblem.LAST_LINES) {
            return ErrorMessages.capitalised(Messages.get(reason));
        }
        Message lastLine = ControllerProblem.LAST_LINE.with(
                reason.arguments().get(0), reason.arguments().get(1));
        return ErrorMessages.capitalised(Messages.get(lastLine)) + "\n" + Messages.get("verdict.printed");
    }

    private static boolean isEnd(SessionFrame frame, SimulationSetup setup) {
        return frame.snapshot().tick() > 0 && frame.snapshot().tick() == setup.ticks();
    }

    private static RunVerdict atEnd(SessionFrame frame, List<Expectation.Condition> required) {
        List<Expectation.Condition> unmet =
                required.stream().filter(item -> item.unmet(frame).isPresent()).toList();
        Optional<Collision> collision = frame.snapshot().collision();
        String detail = Stream.concat(
                        unmet.stream()
                                .map(item ->
                                        ExpectationText.format(item) + " (" + ExpectationText.value(item, frame) + ")"),
                        collision.map(contact -> ContactText.collision(contact) + ". " + faultText(contact)).stream())
                .collect(Collectors.joining("; "));
        String title = unmet.isEmpty()
                ? Messages.get(
                        required.isEmpty() ? "verdict.finished" : "verdict.held",
                        NumberText.format("%.3f", frame.snapshot().time()))
                : Messages.get(
                        "verdict.unmet",
                        NumberText.format("%.3f", frame.snapshot().time()),
                        Integer.toString(unmet.size()),
                        Integer.toString(required.size()));
        return new RunVerdict(
                unmet.isEmpty() && (collision.isEmpty() || isCollisionExpected(required)),
                title,
                detail,
                collision.map(RunVerdict::eventTick).orElse(NONE));
    }

    private static RunVerdict atCollision(Collision collision, List<Expectation.Condition> required) {
        boolean expected = isCollisionExpected(required);
        return new RunVerdict(
                expected,
                ContactText.collision(collision),
                (expected ? Messages.get("verdict.asExpected") + " " : "") + faultText(collision),
                eventTick(collision));
    }

    /** Returns the tick of a collision, 0 for one that an edit causes before the first tick. */
    private static long eventTick(Collision collision) {
        return collision.time() > 0 ? collision.tick() : 0;
    }

    /** Returns whether a collision is no failure, neither when it happens nor at the end of the run. */
    private static boolean isCollisionExpected(List<Expectation.Condition> required) {
        return required.contains(new Expectation.Collides(true));
    }

    /** Returns which faults were active at a collision, in a text that is short however many there were. */
    static String faultText(Collision collision) {
        Map<String, List<String>> sensors = new LinkedHashMap<>();
        collision.faults().forEach((id, faults) -> sensors.computeIfAbsent(
                        FaultText.format(faults), text -> new ArrayList<>())
                .add(id));
        collision.switchedOff().forEach(id -> sensors.computeIfAbsent(
                        Messages.get("timeline.off"), text -> new ArrayList<>())
                .add(id));
        List<String> entries = Stream.concat(
                        sensors.entrySet().stream().flatMap(entry -> faultEntries(entry.getKey(), entry.getValue())),
                        Stream.of(MotorSide.values()).flatMap(side -> motorEntries(collision.motorFaults(), side)))
                .toList();
        if (entries.isEmpty()) {
            return Messages.get("verdict.noFaults");
        }
        int hidden = entries.size() - MAX_ENTRIES;
        // The names of some faults have a comma.
        String active = entries.stream().limit(MAX_ENTRIES).collect(Collectors.joining("; "));
        return Messages.get(
                "verdict.faults", hidden > 0 ? Messages.get("verdict.more", active, Integer.toString(hidden)) : active);
    }

    /** Returns the sensors of a fault by name, or their number if there are many. */
    private static Stream<String> faultEntries(String fault, List<String> sensors) {
        return sensors.size() > MAX_NAMED
                ? Stream.of(Messages.get("verdict.sensors", Integer.toString(sensors.size()), fault))
                : sensors.stream().map(id -> id + " " + fault);
    }

    private static Stream<String> motorEntries(MotorFaults faults, MotorSide side) {
        return faults.of(side).stream().map(fault -> FaultText.motors(side) + " " + FaultText.format(fault));
    }

    /** Returns the tick to go to in order to see what went wrong. */
    long tickBefore(double dt) {
        return Math.max(0, event - Math.round(LEAD_TIME / dt));
    }
}
