package faultline.scenario.xml;

import faultline.control.ControllerSpec;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** Makes the controller's settings of its element. */
final class ControllerReader {

    private static final Map<String, Function<AttributeReader, ControllerSpec>> TYPE_READERS = new LinkedHashMap<>();
    private static final Map<String, WallSide> WALL_SIDES = new LinkedHashMap<>();
    private static final Map<String, TimingRule> TIMING_RULES = new LinkedHashMap<>();

    private static final Map<String, Boolean> SWITCH = new LinkedHashMap<>();

    static {
        SWITCH.put("on", true);
        SWITCH.put("off", false);
        TYPE_READERS.put("wall-follower", ControllerReader::readWallFollower);
        TYPE_READERS.put("none", fields -> new ControllerSpec.None());
        TYPE_READERS.put(
                "drive",
                fields -> new ControllerSpec.Drive(
                        fields.number("left", NumberRange.VOLTAGE, 0), fields.number("right", NumberRange.VOLTAGE, 0)));
        for (WallSide hand : WallSide.values()) {
            WALL_SIDES.put(hand.fileName(), hand);
        }
        for (TimingRule timing : TimingRule.values()) {
            TIMING_RULES.put(timing.fileName(), timing);
        }
    }

    private ControllerReader() {}

    static ControllerSpec read(XmlElement node, Problems complaints) {
        ElementRules.checkChildren(node, List.of(), complaints);
        AttributeReader fields = new AttributeReader(node, complaints);
        ControllerSpec controller = fields.choice("type", TYPE_READERS, ControllerReader::readWallFollower)
                .apply(fields);
        fields.reportUnknownAndMissing();
        return controller;
    }

    private static ControllerSpec readWallFollower(AttributeReader fields) {
        ControllerSpec.WallFollowing usual = ControllerSpec.WallFollowing.DEFAULT;
        return new ControllerSpec.WallFollowing(
                fields.number("distance", NumberRange.SIZE, usual.distance()),
                fields.choice("hand", WALL_SIDES, usual.side()),
                fields.number("period", NumberRange.TIME, usual.period()),
                fields.choice("timing", TIMING_RULES, usual.timingRule()),
                fields.choice("diagnosis", SWITCH, usual.diagnosis()));
    }
}
