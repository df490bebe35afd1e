package faultline.scenario;

import faultline.geometry.Vec;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/**
 * The attributes of one element, asked for one by one. What is wrong is complained of and read as a stand-in value, so that reading goes on
 * and finds the next fault too; whoever reads throws everything away at the end if there were complaints.
 */
final class Fields {

    /** Where to find the schema; editors put it in, and it says nothing to us. */
    private static final Set<String> EDITORS_HINTS = Set.of("xsi:schemaLocation", "xsi:noNamespaceSchemaLocation");

    private static final String ANY_ID = "1 to 100 characters, none of them a comma, a double quote or a control character";

    /** Enough for any outline; stands in for points that could not be read. */
    private static final List<Vec> ANY_POINTS = List.of(Vec.ZERO, new Vec(1, 0), new Vec(0, 1));

    private final Node node;
    private final Complaints complaints;
    private final Set<String> known = new LinkedHashSet<>();
    private final Map<String, Supplier<String>> missing = new LinkedHashMap<>();

    Fields(Node node, Complaints complaints) {
        this.node = node;
        this.complaints = complaints;
    }

    boolean has(String name) {
        known.add(name);
        return node.attributes().containsKey(name);
    }

    Optional<String> text(String name) {
        known.add(name);
        return Optional.ofNullable(node.attributes().get(name));
    }

    /** A number that must be there. */
    double number(String name, Range range) {
        return required(name, () -> number(range)).map(text -> read(name, text, range)).orElse(standIn(range));
    }

    double number(String name, Range range, double fallback) {
        return text(name).map(text -> read(name, text, range)).orElse(fallback);
    }

    /** An angle in degrees, read to radians. */
    double angle(String name, Range range) {
        return required(name, () -> plain(range)).map(text -> readAngle(name, text, range)).orElse(0.0);
    }

    double angle(String name, Range range, double fallback) {
        return text(name).map(text -> readAngle(name, text, range)).orElse(fallback);
    }

    /** A cone, whose nearest number of radians must be less than pi too. */
    double cone(double fallback) {
        double radians = angle("cone", Range.CONE, fallback);
        if (radians > 0 && radians < StrictMath.PI) {
            return radians;
        }
        complain("cone", text("cone").orElse(""), plain(Range.CONE));
        return fallback;
    }

    boolean flag(String name) {
        return required(name, () -> "true or false").map(text -> flag(name, text)).orElse(false);
    }

    boolean flag(String name, boolean fallback) {
        return text(name).map(text -> flag(name, text)).orElse(fallback);
    }

    private boolean flag(String name, String text) {
        return choice(name, text, Map.of("true", true, "false", false), List.of("true", "false")).orElse(false);
    }

    long whole(String name, long least, long most, long fallback) {
        return text(name).map(text -> whole(name, text, least, most)).orElse(fallback);
    }

    private long whole(String name, String text, long least, long most) {
        try {
            long value = Long.parseLong(text.strip());
            if (value >= least && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Told below, like a number out of range.
        }
        complain(name, text, "a whole number from " + least + " to " + most);
        return least;
    }

    /** A name of something, which must be there. */
    String id(String name) {
        Optional<String> given = required(name, () -> ANY_ID);
        given.filter(text -> !isId(text)).ifPresent(text -> complain(name, text, ANY_ID));
        return given.filter(Fields::isId).orElse("?");
    }

    private static boolean isId(String text) {
        return !text.isEmpty() && text.length() <= 100
                && text.chars().noneMatch(c -> c == ',' || c == '"' || Character.isISOControl(c));
    }

    /** One of a few words, which must be there. */
    <T> Optional<T> choice(String name, Map<String, T> options) {
        List<String> words = List.copyOf(options.keySet());
        return required(name, () -> Quoting.list(words)).flatMap(text -> choice(name, text, options, words));
    }

    <T> T choice(String name, Map<String, T> options, T fallback) {
        List<String> words = List.copyOf(options.keySet());
        return text(name).flatMap(text -> choice(name, text, options, words)).orElse(fallback);
    }

    private <T> Optional<T> choice(String name, String text, Map<String, T> options, List<String> words) {
        Optional<T> chosen = Optional.ofNullable(options.get(text.strip()));
        if (chosen.isEmpty()) {
            complain(name, text, Quoting.list(words) + Spelling.hint(text.strip(), words));
        }
        return chosen;
    }

    /** Points as "x,y x,y", which must be there; no more of them than there may be. */
    List<Vec> points(String name, int least, int most) {
        String allowed = least + " or more points as x,y with blanks between them, each number " + Range.COORDINATE;
        List<Vec> points = required(name, () -> allowed).map(text -> points(name, text, most, allowed)).orElse(ANY_POINTS);
        if (points.size() < least) {
            complain(name, text(name).orElse(""), allowed);
            return ANY_POINTS;
        }
        return points;
    }

    private List<Vec> points(String name, String text, int most, String allowed) {
        List<Vec> points = new ArrayList<>();
        PointText pairs = new PointText(text);
        while (pairs.hasNext() && points.size() < most) {
            String pair = pairs.next();
            Optional<Vec> point = PointText.point(pair);
            if (point.isEmpty()) {
                complain(name, pair, allowed);
                return ANY_POINTS;
            }
            points.add(point.get());
        }
        if (pairs.hasNext()) {
            complaints.add(node, subject(name) + " holds more points than are left of the " + Limits.MOST_PARTS
                    + " obstacles and points that a file may hold");
        }
        return points;
    }

    /** Complains of a value that is there. */
    void complain(String name, String given, String allowed) {
        complaints.add(node, subject(name) + " is " + Quoting.quoted(given) + ", allowed is " + allowed);
    }

    /**
     * Complains of every attribute that was given and never asked for, and of every one that must be there and is not. One that looks like
     * a misspelt name of the other kind is told of once.
     */
    void done() {
        for (String name : node.attributes().keySet()) {
            if (!known.contains(name) && !EDITORS_HINTS.contains(name)) {
                complaints.add(node, "<" + node.name() + "> has no attribute " + Quoting.quoted(name) + ", allowed is "
                        + (known.isEmpty() ? "none" : Quoting.list(known)) + Spelling.hint(name, known));
                Spelling.nearest(name, known).ifPresent(missing::remove);
            }
        }
        missing.forEach((name, allowed) -> complaints.add(node,
                "<" + node.name() + "> lacks the attribute \"" + name + "\", allowed is " + allowed.get()));
    }

    private Optional<String> required(String name, Supplier<String> allowed) {
        Optional<String> text = text(name);
        if (text.isEmpty()) {
            missing.put(name, allowed);
        }
        return text;
    }

    private double read(String name, String text, Range range) {
        Optional<Double> value = Numbers.parse(text).filter(range::contains).map(exact -> Numbers.toDouble(exact, text))
                .filter(nearest -> nearest != 0 || range.leastAllowed());
        if (value.isEmpty()) {
            complain(name, text, number(range));
        }
        return value.orElse(standIn(range));
    }

    private double readAngle(String name, String text, Range range) {
        Optional<BigDecimal> exact = Numbers.parse(text).filter(number -> text.indexOf('e') < 0 && text.indexOf('E') < 0)
                .filter(range::contains);
        if (exact.isEmpty()) {
            complain(name, text, plain(range));
        }
        return exact.map(number -> Numbers.toRadians(number, text)).orElse(1.0);
    }

    private static String number(Range range) {
        return "a number " + range;
    }

    private static String plain(Range range) {
        return "a number without exponent, " + range;
    }

    /** A value that nothing else will take offence at. */
    private static double standIn(Range range) {
        return Math.min(1, range.most().doubleValue());
    }

    private String subject(String name) {
        return name + " of <" + node.name() + ">";
    }
}
