package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.GainRule;
import faultline.control.RecordedDecision;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.ControllerProviders;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringTokenizer;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;

/** Reads the controller element. */
final class ControllerReader {

    private static final String DEFAULT_TYPE = ControllerSpec.WallFollowing.TYPE;
    private static final Boolean[] SWITCH = {true, false};
    private static final Map<String, Function<AttributeReader, ControllerSpec>> TYPE_READERS = new LinkedHashMap<>();
    private static final Map<String, Function<AttributeReader, GainRule>> GAIN_RULES = new LinkedHashMap<>();

    static {
        GAIN_RULES.put("automatic", fields -> GainRule.AUTOMATIC);
        GAIN_RULES.put("length", fields -> new GainRule.Length(fields.number("length", NumberRange.SIZE)));
        GAIN_RULES.put(
                "fixed",
                fields -> new GainRule.Fixed(
                        fields.number("kp", NumberRange.GAIN), fields.number("kd", NumberRange.GAIN)));
        TYPE_READERS.put(DEFAULT_TYPE, ControllerReader::readWallFollower);
        TYPE_READERS.put(ControllerSpec.None.TYPE, fields -> new ControllerSpec.None());
        TYPE_READERS.put(ControllerSpec.Drive.TYPE, ControllerReader::readDrive);
        TYPE_READERS.put(
                ControllerSpec.Extern.TYPE,
                fields -> new ControllerSpec.Extern(readPeriod(fields), readDistance(fields)));
        TYPE_READERS.put(
                ControllerSpec.Recorded.TYPE,
                fields -> new ControllerSpec.Recorded(
                        readDistance(fields), fields.integer("ticks", 0, DecisionText.MAX_TICKS, 0), List.of()));
    }

    private ControllerReader() {}

    static ControllerSpec read(XmlElement node, Problems problems) {
        AttributeReader fields = new AttributeReader(node, problems);
        ControllerSpec controller = read(node, fields, problems);
        fields.reportUnknownAndMissing();
        return controller instanceof ControllerSpec.Recorded empty
                ? new ControllerSpec.Recorded(empty.wanted(), empty.ticks(), readDecisions(node, problems))
                : controller;
    }

    private static ControllerSpec read(XmlElement node, AttributeReader fields, Problems problems) {
        String type = type(node);
        boolean provided = isProvided(type);
        if (provided || TYPE_READERS.containsKey(type)) {
            // The elements of an unknown controller may be those that it needs.
            ElementRules.checkChildren(node, children(type), problems);
        }
        if (provided) {
            fields.isPresent("type");
            return new ControllerSpec.Provided(
                    type, readPeriod(fields), readDistance(fields), readSettings(node, problems));
        }
        return TYPE_READERS.containsKey(type)
                ? fields.choice("type", TYPE_READERS, ControllerReader::readWallFollower)
                        .apply(fields)
                : readUnknown(type, fields);
    }

    static String type(XmlElement node) {
        return node.attributes().getOrDefault("type", DEFAULT_TYPE).strip();
    }

    private static boolean isProvided(String type) {
        return !TYPE_READERS.containsKey(type) && ControllerProviders.names().contains(type);
    }

    /** Returns the attributes of an element that a controller of its type does not have. */
    static List<String> attributesOfOtherTypes(XmlElement node) {
        Problems ignored = new Problems("");
        AttributeReader fields = new AttributeReader(node, ignored);
        read(node, fields, ignored);
        return fields.unread().toList();
    }

    /** Returns the names of the elements that a controller of a type may contain. */
    static List<String> children(String type) {
        return isProvided(type)
                ? List.of("setting")
                : type.equals(ControllerSpec.Recorded.TYPE) ? List.of("decisions") : List.of();
    }

    /** Reports a type that is neither one of the program nor on the class path, and reads a wall follower. */
    private static ControllerSpec readUnknown(String type, AttributeReader fields) {
        List<String> known = Stream.concat(TYPE_READERS.keySet().stream(), ControllerProviders.names().stream())
                .distinct()
                .toList();
        fields.text("type")
                .ifPresent(given -> fields.report(
                        "type", given, Allowed.withHint(Allowed.CONTROLLERS.with(Allowed.names(known)), type, known)));
        return readWallFollower(fields);
    }

    private static ControllerSpec readWallFollower(AttributeReader fields) {
        return readWallFollower(fields, ControllerSpec.WallFollowing.DEFAULT);
    }

    private static ControllerSpec.WallFollowing readWallFollower(
            AttributeReader fields, ControllerSpec.WallFollowing defaults) {
        return new ControllerSpec.WallFollowing(
                fields.number("distance", NumberRange.SIZE, defaults.distance()),
                fields.choice("hand", WallSide.values(), WallSide::fileName, defaults.side()),
                fields.number("period", NumberRange.TIME, defaults.period()),
                fields.choice("timing", TimingRule.values(), TimingRule::fileName, defaults.timingRule()),
                fields.choice("diagnosis", SWITCH, ControllerReader::switchText, defaults.diagnosis()),
                fields.choice("gains", GAIN_RULES, given -> defaults.gainRule()).apply(fields),
                readThresholds(fields, defaults.thresholds()));
    }

    static String switchText(boolean on) {
        return on ? "on" : "off";
    }

    private static Thresholds readThresholds(AttributeReader fields, Thresholds defaults) {
        Thresholds result = defaults;
        for (Threshold threshold : Threshold.values()) {
            String name = threshold.fileName();
            if (fields.isPresent(name)) {
                result = result.with(threshold, fields.number(name, NumberRange.of(threshold.quantity())));
            }
        }
        return result;
    }

    /** Returns the follower whose values hold for attributes that a command of the timeline omits. */
    static ControllerSpec.WallFollowing defaultsFor(ControllerSpec controller) {
        return controller instanceof ControllerSpec.WallFollowing follower
                ? follower
                : ControllerSpec.WallFollowing.DEFAULT;
    }

    /** Reads a controller of the program; omitted attributes of a wall follower have their default values. */
    static ControllerSpec.BuiltIn readBuiltIn(AttributeReader fields, ControllerSpec.WallFollowing defaults) {
        Map<String, Function<AttributeReader, ControllerSpec.BuiltIn>> types = new LinkedHashMap<>();
        types.put(DEFAULT_TYPE, own -> readWallFollower(own, defaults));
        types.put(ControllerSpec.None.TYPE, own -> new ControllerSpec.None());
        types.put(ControllerSpec.Drive.TYPE, ControllerReader::readDrive);
        return fields.choice("type", types, types.get(DEFAULT_TYPE)).apply(fields);
    }

    private static ControllerSpec.Drive readDrive(AttributeReader fields) {
        return new ControllerSpec.Drive(
                fields.number("left", NumberRange.VOLTAGE, 0), fields.number("right", NumberRange.VOLTAGE, 0));
    }

    private static double readDistance(AttributeReader fields) {
        return fields.number("distance", NumberRange.SIZE, ControllerSpec.WallFollowing.DEFAULT.distance());
    }

    private static double readPeriod(AttributeReader fields) {
        return fields.number("period", NumberRange.TIME, ControllerSpec.WallFollowing.DEFAULT.period());
    }

    private static Map<String, String> readSettings(XmlElement node, Problems problems) {
        Map<String, String> settings = new TreeMap<>();
        node.childrenNamed("setting").forEach(child -> {
            ElementRules.checkChildren(child, List.of(), problems);
            AttributeReader fields = new AttributeReader(child, problems);
            String name = fields.id("name");
            String value = fields.requiredText("value", Allowed.TEXT.with()).orElse("");
            if (settings.put(name, value) != null
                    && name.equals(child.attributes().get("name"))) {
                problems.add(child, ProblemKind.DUPLICATE_SETTING.with(MessageText.excerpt(name)));
            }
            fields.reportUnknownAndMissing();
        });
        return settings;
    }

    private static List<RecordedDecision> readDecisions(XmlElement node, Problems problems) {
        List<RecordedDecision> decisions = new ArrayList<>();
        long end = 0;
        for (XmlElement child : node.childrenNamed("decisions").toList()) {
            end = readDecisions(child, end, decisions, problems);
        }
        return decisions;
    }

    /** Adds the decisions of an element, given the tick at which the earlier ones end, and returns where these end. */
    private static long readDecisions(
            XmlElement node, long earlierEnd, List<RecordedDecision> decisions, Problems problems) {
        AttributeReader fields = new AttributeReader(node, problems);
        if (earlierEnd > 0) {
            Message later = Allowed.CLOSED.with(earlierEnd, DecisionText.MAX_TICKS);
            fields.requiredText("from", Allowed.WHOLE_NUMBER.with(later));
        }
        long tick = fields.integer("from", earlierEnd, DecisionText.MAX_TICKS, earlierEnd);
        String state = fields.text("state").orElse("");
        String why = fields.text("why").orElse("");
        fields.reportUnknownAndMissing();
        ElementRules.checkOnlyText(node, problems);
        StringTokenizer tokens = new StringTokenizer(node.text());
        while (tokens.hasMoreTokens()) {
            String token = tokens.nextToken();
            Optional<DecisionText> read = DecisionText.parse(token);
            if (read.isEmpty()) {
                fields.report("decisions", token, Allowed.DECISIONS.with());
                return tick;
            }
            if (tick + read.get().ticks() > DecisionText.MAX_TICKS) {
                fields.report("decisions", token, Allowed.DECISIONS_END.with(DecisionText.MAX_TICKS));
                return tick;
            }
            decisions.add(
                    new RecordedDecision(tick, read.get().left(), read.get().right(), state, why));
            tick += read.get().ticks();
        }
        return tick;
    }
}
