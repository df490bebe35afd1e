package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.GainRule;
import faultline.control.RecordedDecision;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.ControllerProviders;
import faultline.io.DecimalText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import faultline.scenario.xml.XmlWriter;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringTokenizer;
import java.util.TreeMap;
import java.util.function.Function;

/** Reads and writes the controller element. */
final class ControllerXml {

    private static final String DEFAULT_TYPE = "wall-follower";
    private static final String EXTERN = "extern";
    private static final String RECORDED = "recorded";
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
        TYPE_READERS.put(DEFAULT_TYPE, ControllerXml::readWallFollower);
        TYPE_READERS.put("none", fields -> new ControllerSpec.None());
        TYPE_READERS.put("drive", ControllerXml::readDrive);
        TYPE_READERS.put(EXTERN, fields -> new ControllerSpec.Extern(readPeriod(fields)));
        TYPE_READERS.put(
                RECORDED,
                fields -> new ControllerSpec.Recorded(
                        readDistance(fields), fields.integer("ticks", 0, Long.MAX_VALUE, 0), List.of()));
    }

    private ControllerXml() {}

    static ControllerSpec read(XmlElement node, Problems problems) {
        AttributeReader fields = new AttributeReader(node, problems);
        String type = node.attributes().getOrDefault("type", DEFAULT_TYPE).strip();
        boolean provided = !TYPE_READERS.containsKey(type)
                && ControllerProviders.find(type).isPresent();
        ElementRules.checkChildren(
                node,
                provided ? List.of("setting") : type.equals(RECORDED) ? List.of("decisions") : List.of(),
                problems);
        ControllerSpec controller = provided
                ? new ControllerSpec.Provided(type, readPeriod(fields), readSettings(node, problems))
                : fields.choice("type", knownTypes(type), ControllerXml::readWallFollower)
                        .apply(fields);
        if (provided) {
            fields.isPresent("type");
        }
        fields.reportUnknownAndMissing();
        return controller instanceof ControllerSpec.Recorded empty
                ? new ControllerSpec.Recorded(empty.wanted(), empty.ticks(), readDecisions(node, problems))
                : controller;
    }

    /** Returns the types of the program; for an unknown type also those on the class path, to be named with it. */
    private static Map<String, Function<AttributeReader, ControllerSpec>> knownTypes(String type) {
        Map<String, Function<AttributeReader, ControllerSpec>> known = new LinkedHashMap<>(TYPE_READERS);
        if (!known.containsKey(type)) {
            ControllerProviders.names().forEach(name -> known.putIfAbsent(name, ControllerXml::readWallFollower));
        }
        return known;
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
                fields.choice("diagnosis", SWITCH, ControllerXml::switchText, defaults.diagnosis()),
                fields.choice("gains", GAIN_RULES, given -> defaults.gainRule()).apply(fields),
                readThresholds(fields, defaults.thresholds()));
    }

    private static String switchText(boolean on) {
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
        types.put("none", own -> new ControllerSpec.None());
        types.put("drive", ControllerXml::readDrive);
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
            settings.put(
                    fields.id("name"),
                    fields.requiredText("value", Allowed.TEXT.english()).orElse(""));
            fields.reportUnknownAndMissing();
        });
        return settings;
    }

    private static List<RecordedDecision> readDecisions(XmlElement node, Problems problems) {
        List<RecordedDecision> decisions = new ArrayList<>();
        node.childrenNamed("decisions").forEach(child -> {
            AttributeReader fields = new AttributeReader(child, problems);
            long tick = fields.integer("from", 0, Long.MAX_VALUE, 0);
            String state = fields.text("state").orElse("");
            String why = fields.text("why").orElse("");
            fields.reportUnknownAndMissing();
            StringTokenizer tokens = new StringTokenizer(child.text());
            while (tokens.hasMoreTokens()) {
                String token = tokens.nextToken();
                Optional<DecisionText> read = DecisionText.parse(token);
                if (read.isEmpty()) {
                    fields.report("decisions", token, Allowed.DECISIONS.with());
                    return;
                }
                decisions.add(
                        new RecordedDecision(tick, read.get().left(), read.get().right(), state, why));
                tick += read.get().ticks();
            }
        });
        return decisions;
    }

    static void write(ControllerSpec spec, XmlWriter out) {
        if (spec instanceof ControllerSpec.Chosen chosen) {
            write(chosen.original(), out);
            return;
        }
        out.beginElement("controller");
        if (spec instanceof ControllerSpec.BuiltIn builtIn) {
            writeBuiltIn(builtIn, ControllerSpec.WallFollowing.DEFAULT, false, out);
        } else if (spec instanceof ControllerSpec.Extern extern) {
            out.attribute("type", EXTERN).attribute("period", extern.period());
        } else if (spec instanceof ControllerSpec.Provided provided) {
            out.attribute("type", provided.name()).attribute("period", provided.period());
            new TreeMap<>(provided.settings()).forEach((name, value) -> out.beginElement("setting")
                    .attribute("name", name)
                    .attribute("value", value)
                    .endElement());
        } else if (spec instanceof ControllerSpec.Recorded recorded) {
            writeRecorded(recorded, out);
        }
        out.endElement();
    }

    /**
     * Writes the attributes of a controller of the program.
     *
     * @param spec the controller
     * @param defaults the values that a reader uses for omitted thresholds
     * @param all whether a follower's diagnosis and gains are written even if they have their default values
     */
    static XmlWriter writeBuiltIn(
            ControllerSpec.BuiltIn spec, ControllerSpec.WallFollowing defaults, boolean all, XmlWriter out) {
        if (spec instanceof ControllerSpec.WallFollowing follow) {
            out.attribute("type", DEFAULT_TYPE)
                    .attribute("distance", follow.distance())
                    .attribute("hand", follow.side().fileName())
                    .attribute("period", follow.period())
                    .attribute("timing", follow.timingRule().fileName());
            if (all || !follow.diagnosis()) {
                out.attribute("diagnosis", switchText(follow.diagnosis()));
            }
            writeGains(follow.gainRule(), all, out);
            writeThresholds(follow.thresholds(), defaults.thresholds(), out);
        } else if (spec instanceof ControllerSpec.Drive drive) {
            out.attribute("type", "drive").attribute("left", drive.leftVolts()).attribute("right", drive.rightVolts());
        } else {
            out.attribute("type", "none");
        }
        return out;
    }

    private static void writeGains(GainRule rule, boolean all, XmlWriter out) {
        if (rule instanceof GainRule.Length length) {
            out.attribute("gains", "length").attribute("length", length.metres());
        } else if (rule instanceof GainRule.Fixed fixed) {
            out.attribute("gains", "fixed")
                    .attribute("kp", fixed.proportional())
                    .attribute("kd", fixed.derivative());
        } else if (all) {
            out.attribute("gains", "automatic");
        }
    }

    private static void writeThresholds(Thresholds thresholds, Thresholds defaults, XmlWriter out) {
        for (Threshold threshold : Threshold.values()) {
            double value = thresholds.get(threshold);
            if (Double.compare(value, defaults.get(threshold)) != 0) {
                out.attribute(threshold.fileName(), value);
            }
        }
    }

    /** Writes one element for each stretch of decisions with the same state and reason. */
    private static void writeRecorded(ControllerSpec.Recorded recorded, XmlWriter out) {
        out.attribute("type", RECORDED)
                .attribute("distance", recorded.wanted())
                .attribute("ticks", String.valueOf(recorded.ticks()));
        List<RecordedDecision> decisions = recorded.decisions();
        int next = 0;
        while (next < decisions.size()) {
            RecordedDecision first = decisions.get(next);
            StringBuilder text = new StringBuilder();
            boolean same = true;
            while (same) {
                RecordedDecision decision = decisions.get(next++);
                boolean last = next == decisions.size();
                long end = last
                        ? Math.max(decision.tick() + 1, recorded.ticks())
                        : decisions.get(next).tick();
                text.append(text.isEmpty() ? "" : " ").append(DecisionText.format(decision, end));
                same = !last
                        && decisions.get(next).state().equals(first.state())
                        && decisions.get(next).condition().equals(first.condition());
            }
            out.beginElement("decisions")
                    .attribute("from", String.valueOf(first.tick()))
                    .attribute("state", first.state())
                    .attribute("why", first.condition())
                    .endTextElement(text.toString());
        }
    }

    /**
     * The text {@code left,right*ticks}: two voltages and the number of ticks for which they hold; without a number, it
     * is one.
     *
     * @param left volts
     * @param right volts
     * @param ticks the number of ticks, at least one
     */
    private record DecisionText(double left, double right, long ticks) {

        private static final BigDecimal MAX_TICKS = BigDecimal.valueOf(1L << 53);

        static String format(RecordedDecision decision, long end) {
            String pair = DecimalText.format(decision.leftVolts()) + "," + DecimalText.format(decision.rightVolts());
            long ticks = end - decision.tick();
            return ticks == 1 ? pair : pair + "*" + ticks;
        }

        static Optional<DecisionText> parse(String text) {
            int comma = text.indexOf(',');
            int star = text.indexOf('*');
            if (comma < 0 || star >= 0 && star < comma) {
                return Optional.empty();
            }
            Optional<Double> left = parseVolts(text.substring(0, comma));
            Optional<Double> right = parseVolts(text.substring(comma + 1, star < 0 ? text.length() : star));
            Optional<Long> ticks = star < 0 ? Optional.of(1L) : parseTicks(text.substring(star + 1));
            return left.isPresent() && right.isPresent() && ticks.isPresent()
                    ? Optional.of(new DecisionText(left.get(), right.get(), ticks.get()))
                    : Optional.empty();
        }

        private static Optional<Double> parseVolts(String text) {
            Optional<BigDecimal> exact = DecimalText.parse(text);
            return exact.map(number -> DecimalText.toDouble(number, text)).filter(Double::isFinite);
        }

        private static Optional<Long> parseTicks(String text) {
            return DecimalText.parse(text)
                    .filter(number -> number.signum() > 0 && number.compareTo(MAX_TICKS) <= 0)
                    .filter(number -> number.stripTrailingZeros().scale() <= 0)
                    .map(BigDecimal::longValue);
        }
    }
}
