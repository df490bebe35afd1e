package faultline.gui.edit;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Threshold;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The part of the world that a command changes. Two commands of one edit with equal targets are merged into one.
 *
 * @param kind the kind of change
 * @param subject the id of what is changed, or the command itself if such commands are never merged
 * @param repeatable whether commands in quick succession are one edit, as nudges or a spinner held down are
 */
record EditTarget(String kind, Object subject, boolean repeatable) {

    /** The kind of the targets of setup edits. */
    static final String SETUP = "setup";

    /** The kind of the targets of commands that belong to a time of the run. */
    static final String EVENT = "event";

    /** The kind of the targets of commands that remove an obstacle. */
    static final String REMOVAL = "remove";

    private static final Command.CommandCases<EditTarget> FINDER = Command.CommandCases.ofSetup(
            timed -> new EditTarget(EVENT, timed, false),
            configureSensor ->
                    new EditTarget("configure", configureSensor.sensor().id(), true),
            moveObstacle -> new EditTarget("move", moveObstacle.obstacle(), true),
            placeObstacle -> new EditTarget("place", placeObstacle.obstacle().id(), false),
            removeObstacle -> new EditTarget(REMOVAL, removeObstacle, false),
            setPlatform -> new EditTarget("platform", "", true),
            configureController -> new EditTarget("controller", "", true));

    /**
     * Returns the target of a command as part of a gesture; different settings of the controller are different ones.
     */
    static EditTarget ofGesture(Command command, ControllerSpec before) {
        return command instanceof Command.ConfigureController change
                        && change.controller() instanceof WallFollowing after
                        && before instanceof WallFollowing follower
                ? new EditTarget("controller", changedSettings(settings(follower), settings(after)), true)
                : of(command);
    }

    private static List<Object> settings(WallFollowing follower) {
        List<Object> settings = new ArrayList<>(List.of(
                follower.distance(),
                follower.side(),
                follower.period(),
                follower.timingRule(),
                follower.diagnosis(),
                follower.gainRule()));
        Arrays.stream(Threshold.values()).map(follower.thresholds()::get).forEach(settings::add);
        return settings;
    }

    private static List<Integer> changedSettings(List<Object> before, List<Object> after) {
        return IntStream.range(0, before.size())
                .filter(i -> !before.get(i).equals(after.get(i)))
                .boxed()
                .toList();
    }

    static EditTarget of(Command command) {
        return command.match(FINDER);
    }
}
