package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.Hand;
import faultline.control.Timing;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** Makes the controller's settings of its element. */
final class ControllerReader {

    private static final Map<String, Function<Fields, ControllerSpec>> TYPES = new LinkedHashMap<>();
    private static final Map<String, Hand> HANDS = new LinkedHashMap<>();
    private static final Map<String, Timing> TIMINGS = new LinkedHashMap<>();

    static {
        TYPES.put("wall-follower", ControllerReader::wallFollower);
        TYPES.put("none", fields -> new ControllerSpec.None());
        TYPES.put("drive", fields -> new ControllerSpec.Drive(
                fields.number("left", Range.VOLTAGE, 0), fields.number("right", Range.VOLTAGE, 0)));
        for (Hand hand : Hand.values()) {
            HANDS.put(hand.fileName(), hand);
        }
        for (Timing timing : Timing.values()) {
            TIMINGS.put(timing.fileName(), timing);
        }
    }

    private ControllerReader() {
    }

    static ControllerSpec read(Node node, Complaints complaints) {
        Content.check(node, List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        ControllerSpec controller = fields.choice("type", TYPES, ControllerReader::wallFollower).apply(fields);
        fields.done();
        return controller;
    }

    private static ControllerSpec wallFollower(Fields fields) {
        ControllerSpec.WallFollowing usual = ControllerSpec.WallFollowing.DEFAULT;
        return new ControllerSpec.WallFollowing(fields.number("distance", Range.SIZE, usual.distance()),
                fields.choice("hand", HANDS, usual.hand()), fields.number("period", Range.TIME, usual.period()),
                fields.choice("timing", TIMINGS, usual.timing()));
    }
}
