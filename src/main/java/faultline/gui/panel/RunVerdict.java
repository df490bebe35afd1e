package faultline.gui.panel;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.gui.text.ExpectationText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.text.ReadingText;
import faultline.scenario.Scenario;
import faultline.world.Collision;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The end of a run: a collision, with a failure, or at the scenario's duration.
 *
 * @param success whether nothing is wrong
 * @param title the event, in a few words
 * @param detail why, empty if there is nothing to add
 * @param event the tick of what went wrong, -1 if nothing did
 */
public record RunVerdict(boolean success, String title, String detail, long event) {

    /** The time before the event to which the run is moved back, seconds. */
    private static final double LEAD_TIME = 2;

    private static final int NONE = -1;

    /** Returns the verdict on a run, empty while the run is in progress. */
    public static Optional<RunVerdict> of(SessionFrame frame, SessionStatus status, Scenario scenario) {
        if (status.failure().isPresent()) {
            return Optional.of(new RunVerdict(
                    false,
                    Messages.get(
                            "verdict.broken",
                            NumberText.format("%.3f", frame.snapshot().time())),
                    capitalised(Messages.get(status.failure().get())),
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

    private static String capitalised(String sentence) {
        return sentence.isEmpty() ? "" : sentence.substring(0, 1).toUpperCase(Locale.ROOT) + sentence.substring(1);
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
                        collision.map(RunVerdict::collisionText).stream())
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
                unmet.isEmpty(), title, detail, collision.map(Collision::tick).orElse((long) NONE));
    }

    private static RunVerdict atCollision(Collision collision, List<Expectation.Condition> required) {
        boolean expected = required.contains(new Expectation.Collides(true));
        return new RunVerdict(
                expected,
                Messages.get("verdict.collided", collision.obstacle(), NumberText.format("%.3f", collision.time())),
                (expected ? Messages.get("verdict.asExpected") + " " : "") + faultText(collision),
                collision.tick());
    }

    private static String collisionText(Collision collision) {
        return Messages.get("verdict.collided", collision.obstacle(), NumberText.format("%.3f", collision.time()))
                + ". " + faultText(collision);
    }

    /** Returns which faults were active at a collision. */
    private static String faultText(Collision collision) {
        String active = Stream.concat(
                        collision.faults().entrySet().stream()
                                .map(entry -> entry.getKey() + " " + ReadingText.format(entry.getValue())),
                        collision.switchedOff().stream().map(id -> id + " " + Messages.get("reading.off")))
                .collect(Collectors.joining(", "));
        return active.isEmpty() ? Messages.get("verdict.noFaults") : Messages.get("verdict.faults", active);
    }

    /** Returns the tick to go to in order to see what went wrong. */
    public long tickBefore(double dt) {
        return Math.max(0, event - Math.round(LEAD_TIME / dt));
    }
}
