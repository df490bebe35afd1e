package faultline.campaign.plan;

import faultline.control.Threshold;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The path of an attribute in a scenario file: {@code robot/sensor[front]/@cone}, {@code controller/@distance},
 * {@code @duration}, or {@code timeline/fault[2]/@at}, with an id or a number from 1 in the brackets.
 *
 * @param steps the elements from the root element's child down to the element that has the attribute; empty for the
 *     root element
 * @param attribute the name of the attribute
 */
record AttributePath(List<PathStep> steps, String attribute) {

    /** The seed of a run, which {@code <seeds>} gives it. */
    static final AttributePath SEED = new AttributePath(List.of(), "seed");

    /** The form of a path, for error messages. */
    static final String RULE =
            "a path in a scenario file, such as robot/sensor[front]/@cone, controller/@distance or @duration";

    /** An element; its id may have slashes and brackets, but not a closing bracket before a slash. */
    private static final Pattern STEP = Pattern.compile("([a-zA-Z]+)(?:\\[((?:(?!]/).)+)])?/", Pattern.DOTALL);

    private static final Pattern ATTRIBUTE = Pattern.compile("@([a-zA-Z]+)");

    private static final Pattern ROOT = Pattern.compile("^scenario/");
    private static final Pattern NEW_WORD = Pattern.compile("([a-z0-9])([A-Z])");
    private static final Pattern NOT_IN_NAME = Pattern.compile("[^a-z0-9]+");
    private static final Pattern AT_END = Pattern.compile("^_|_$");

    /** The attributes, except thresholds, by unit. The name of a column ends with the unit. */
    private static final Map<String, Set<String>> UNITS = Map.of(
            "m",
                    Set.of(
                            "width",
                            "height",
                            "length",
                            "track",
                            "x",
                            "y",
                            "range",
                            "noise",
                            "radius",
                            "rx",
                            "ry",
                            "distance"),
            "deg", Set.of("heading", "bearing", "cone", "specular"),
            "m/s", Set.of("speed"),
            "deg/s", Set.of("turnRate"),
            "s", Set.of("duration", "tick", "period", "timeConstant", "at", "until"),
            "V", Set.of("left", "right", "maxVoltage"),
            "m/s/V", Set.of("speedConstant"));

    AttributePath {
        steps = List.copyOf(steps);
    }

    /**
     * An element by its name, and its id or its number among the elements with its name, from 1; empty for the first or
     * only one.
     */
    record PathStep(String element, String key) {

        private static final Pattern NUMBER = Pattern.compile("[1-9]\\d{0,5}");

        /** Returns whether its key can be a number. */
        boolean isNumbered() {
            return NUMBER.matcher(key).matches();
        }
    }

    /** Returns whether it leads to the type of the controller. */
    boolean isControllerType() {
        return attribute.equals("type") && isOfController();
    }

    /** Returns whether it leads to an attribute of the controller that the robot starts with. */
    boolean isOfController() {
        return steps.size() == 1 && steps.get(0).element().equals("controller");
    }

    /** Parses a path, which may start with {@code scenario/}; returns an empty result if the text is not a path. */
    static Optional<AttributePath> parse(String text) {
        String path = ROOT.matcher(text.strip()).replaceFirst("");
        List<PathStep> steps = new ArrayList<>();
        Matcher step = STEP.matcher(path);
        int end = 0;
        while (step.region(end, path.length()).lookingAt()) {
            steps.add(new PathStep(step.group(1), step.group(2) == null ? "" : step.group(2)));
            end = step.end();
        }
        Matcher attribute = ATTRIBUTE.matcher(path.substring(end));
        return attribute.matches() ? Optional.of(new AttributePath(steps, attribute.group(1))) : Optional.empty();
    }

    /** Returns the path with another key in one of its steps. */
    AttributePath withKey(int index, String key) {
        List<PathStep> others = new ArrayList<>(steps);
        others.set(index, new PathStep(steps.get(index).element, key));
        return new AttributePath(others, attribute);
    }

    /** Returns the unit of the attribute's values, empty if it has none. */
    String unit() {
        return Stream.of(Threshold.values())
                .filter(threshold -> threshold.fileName().equals(attribute))
                .map(threshold -> threshold.quantity().unit())
                .findFirst()
                .or(() -> UNITS.keySet().stream()
                        .filter(unit -> UNITS.get(unit).contains(attribute))
                        .findFirst())
                .orElse("");
    }

    /** Returns whether its values are names or other texts, of which two may differ although they are equal numbers. */
    boolean isText() {
        boolean setting =
                !steps.isEmpty() && steps.get(steps.size() - 1).element.equals("setting");
        return setting || List.of("id", "name", "sensor", "obstacle").contains(attribute);
    }

    /** Returns the name of its column, such as {@code front_cone_deg}. */
    String columnName() {
        String name = snake(attribute) + unitSuffix(unit());
        if (steps.isEmpty()) {
            return name;
        }
        PathStep last = steps.get(steps.size() - 1);
        String owner = last.key.isEmpty() ? last.element : last.key;
        return (owner.matches("\\d.*") ? snake(last.element + "_" + owner) : snake(owner)) + "_" + name;
    }

    /** Returns the end of a column's name for a unit: {@code _m_s} for "m/s". */
    static String unitSuffix(String unit) {
        return unit.isEmpty() ? "" : "_" + unit.toLowerCase(Locale.ROOT).replace('/', '_');
    }

    /** Returns a name in lower_snake. */
    static String snake(String name) {
        String words = NEW_WORD.matcher(name).replaceAll("$1_$2").toLowerCase(Locale.ROOT);
        return AT_END.matcher(NOT_IN_NAME.matcher(words).replaceAll("_")).replaceAll("");
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        for (PathStep step : steps) {
            text.append(step.element)
                    .append(step.key.isEmpty() ? "" : "[" + step.key + "]")
                    .append('/');
        }
        return text + "@" + attribute;
    }
}
