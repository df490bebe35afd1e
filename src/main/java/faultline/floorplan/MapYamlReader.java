package faultline.floorplan;

import faultline.io.ByteCount;
import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.MessageText;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the YAML files of ROS map_server: one mapping, in lines or in braces, of plain or quoted scalars, and
 * {@code origin} as a list in brackets or in lines. Keys that map_server does not know are ignored.
 */
final class MapYamlReader {

    private static final long MAX_BYTES = 1 << 20;
    /** Less than the greatest heading of an obstacle, a million degrees. */
    private static final double MAX_YAW = 17_000;

    private static final List<String> KEYS =
            List.of("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode");

    /** A value and its location. */
    private record YamlEntry(int line, int column, List<String> values) {
        String text() {
            return String.join(", ", values);
        }
    }

    private final Path file;
    private final Map<String, YamlEntry> entries = new LinkedHashMap<>();

    private MapYamlReader(Path file) {
        this.file = file;
    }

    /**
     * {@return the description in a map file}
     *
     * @param file the YAML file; its {@code image} is relative to it
     * @throws FloorPlanException at the first error
     */
    static MapDescription read(Path file) throws FloorPlanException {
        MapYamlReader reader = new MapYamlReader(file);
        reader.parse(readText(file));
        return reader.toDescription();
    }

    private static String readText(Path file) throws FloorPlanException {
        try {
            if (!Files.exists(file)) {
                throw new FloorPlanException(file + ": there is no such file");
            }
            if (!Files.isRegularFile(file)) {
                throw new FloorPlanException(file + ": this is not a regular file; expected a map file");
            }
            if (Files.size(file) > MAX_BYTES) {
                throw new FloorPlanException(file + ": the file has " + ByteCount.format(Files.size(file))
                        + "; expected at most " + ByteCount.format(MAX_BYTES));
            }
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (CharacterCodingException e) {
            throw new FloorPlanException(file + ": the file is not UTF-8 text");
        } catch (FloorPlanException e) {
            throw e;
        } catch (IOException e) {
            throw new FloorPlanException(file + ": the file cannot be read");
        }
    }

    private void parse(String text) throws FloorPlanException {
        String[] lines = text.replaceFirst("^\uFEFF", "").split("\\R", -1);
        String listKey = "";
        for (int i = 0; i < lines.length; i++) {
            int number = i + 1;
            StringBuilder joined = new StringBuilder(stripComment(lines[i]));
            // A mapping in braces or a list in brackets ends in the line that closes it.
            int open = MapYamlFlow.begins(joined.toString()) ? MapYamlFlow.depth(joined.toString()) : 0;
            while (open > 0 && i + 1 < lines.length) {
                String next = stripComment(lines[++i]);
                open += MapYamlFlow.depth(next);
                joined.append('\n').append(next);
            }
            String line = joined.toString();
            String content = line.strip();
            if (content.startsWith("- ") && entries.containsKey(listKey)) {
                entries.get(listKey).values().add(unquote(content.substring(2).strip()));
            } else if (content.startsWith("{") && content.endsWith("}")) {
                parseBraces(number, line);
            } else if (!isMark(line)) {
                listKey = parseEntry(number, 1, line);
            }
        }
    }

    /** Returns whether a line is empty, or begins or ends a document. */
    private static boolean isMark(String line) {
        String content = line.strip();
        return content.isEmpty() || content.equals("---") || content.equals("...") || line.startsWith("%");
    }

    private void parseBraces(int lineNumber, String text) throws FloorPlanException {
        int line = lineNumber;
        int lineBegin = 0;
        int at = 0;
        for (MapYamlFlow.FlowEntry part : MapYamlFlow.parts(text)) {
            for (; at < part.index(); at++) {
                if (text.charAt(at) == '\n') {
                    line++;
                    lineBegin = at + 1;
                }
            }
            parseEntry(line, part.index() - lineBegin + 1, part.text());
        }
    }

    private String parseEntry(int lineNumber, int firstColumn, String line) throws FloorPlanException {
        int colon = line.indexOf(':');
        if (colon < 0) {
            throw problem(
                    lineNumber,
                    firstColumn,
                    "a line is " + MessageText.quoted(line.strip()) + "; expected \"key: value\"");
        }
        String key = unquote(line.substring(0, colon).strip());
        String value = line.substring(colon + 1).strip();
        int column = line.length() - line.substring(colon + 1).stripLeading().length() + firstColumn;
        if (entries.containsKey(key)) {
            throw problem(lineNumber, firstColumn, MessageText.quoted(key) + " is given twice; expected once");
        }
        entries.put(key, new YamlEntry(lineNumber, column, splitValue(value)));
        return key;
    }

    private static List<String> splitValue(String value) {
        List<String> values = new ArrayList<>();
        if (value.startsWith("[") && value.endsWith("]")) {
            for (String part : value.substring(1, value.length() - 1).split(",", -1)) {
                values.add(unquote(part.strip()));
            }
        } else if (!value.isEmpty()) {
            values.add(unquote(value));
        }
        return values;
    }

    /** Removes a comment: a number sign at the beginning or after a blank, outside of quotes. */
    private static String stripComment(String line) {
        for (int i = 0; i < line.length(); i = MapYamlFlow.next(line, i)) {
            if (line.charAt(i) == '#' && (i == 0 || Character.isWhitespace(line.charAt(i - 1)))) {
                return line.substring(0, i);
            }
        }
        return line;
    }

    private static String unquote(String text) {
        boolean quoted = text.length() >= 2
                && (text.startsWith("\"") && text.endsWith("\"") || text.startsWith("'") && text.endsWith("'"));
        return quoted ? text.substring(1, text.length() - 1) : text;
    }

    private MapDescription toDescription() throws FloorPlanException {
        Path image = imageFile();
        BigDecimal resolution = number("resolution", "0.05");
        if (!MapDescription.isResolution(resolution)) {
            throw wrong("resolution", MapDescription.RESOLUTIONS);
        }
        double occupied = share("occupied_thresh", "0.65");
        double free = share("free_thresh", "0.196");
        MapDescription description = new MapDescription(image, resolution, yaw(), mode(), isNegated(), occupied, free);
        if (!Files.isRegularFile(image)) {
            throw wrong("image", "the name of an image file, but there is no file " + image);
        }
        return description;
    }

    private Path imageFile() throws FloorPlanException {
        String name = single("image");
        if (name.isEmpty()) {
            throw wrong("image", "the name of an image file");
        }
        try {
            return file.resolveSibling(name);
        } catch (InvalidPathException e) {
            throw wrong("image", "the name of an image file");
        }
    }

    private double yaw() throws FloorPlanException {
        if (!entries.containsKey("origin")) {
            return 0;
        }
        List<String> values = entries.get("origin").values();
        if (values.size() != 3) {
            throw wrong("origin", "three numbers, [x, y, yaw] in metres and radians");
        }
        double[] numbers = new double[3];
        for (int i = 0; i < 3; i++) {
            Optional<BigDecimal> number = DecimalText.parse(values.get(i));
            numbers[i] = number.isEmpty() ? Double.NaN : number.get().doubleValue();
        }
        if (!Arrays.stream(numbers).allMatch(Double::isFinite)) {
            throw wrong("origin", "three numbers, [x, y, yaw] in metres and radians");
        }
        if (Math.abs(numbers[2]) > MAX_YAW) {
            throw wrong("origin", "[x, y, yaw] with a yaw of at most " + DecimalText.format(MAX_YAW) + " radians");
        }
        return numbers[2];
    }

    private MapMode mode() throws FloorPlanException {
        if (!entries.containsKey("mode")) {
            return MapMode.TRINARY;
        }
        String name = single("mode");
        for (MapMode mode : MapMode.values()) {
            if (mode.fileName().equals(name)) {
                return mode;
            }
        }
        List<String> names =
                Arrays.stream(MapMode.values()).map(MapMode::fileName).toList();
        throw wrong("mode", String.join(", ", names) + DidYouMean.hint(name, names));
    }

    private boolean isNegated() throws FloorPlanException {
        if (!entries.containsKey("negate")) {
            return false;
        }
        return switch (single("negate").toLowerCase(Locale.ROOT)) {
            case "0", "false", "no", "off" -> false;
            case "1", "true", "yes", "on" -> true;
            default -> throw wrong("negate", "0 or 1");
        };
    }

    private double share(String key, String defaultText) throws FloorPlanException {
        double value = number(key, defaultText).doubleValue();
        if (value < 0 || value > 1) {
            throw wrong(key, "a number from 0 to 1");
        }
        return value;
    }

    private BigDecimal number(String key, String defaultText) throws FloorPlanException {
        if (key.equals("resolution") || entries.containsKey(key)) {
            Optional<BigDecimal> number = DecimalText.parse(single(key));
            if (number.isEmpty() || !Double.isFinite(number.get().doubleValue())) {
                throw wrong(key, "a number");
            }
            return number.get();
        }
        return new BigDecimal(defaultText);
    }

    private String single(String key) throws FloorPlanException {
        if (!entries.containsKey(key)) {
            throw problem(1, 1, "there is no " + MessageText.quoted(key) + nearMiss(key));
        }
        if (entries.get(key).values().size() != 1) {
            throw wrong(key, "one value");
        }
        return entries.get(key).values().get(0);
    }

    /** Returns an unknown key that may be a misspelt one. */
    private String nearMiss(String key) {
        return entries.keySet().stream()
                .filter(given -> !KEYS.contains(given))
                .filter(given -> DidYouMean.nearest(given, List.of(key)).isPresent())
                .findFirst()
                .map(given -> "; " + MessageText.quoted(given) + " may be meant as " + MessageText.quoted(key))
                .orElse(", a map file needs it");
    }

    private FloorPlanException wrong(String key, String allowed) {
        YamlEntry entry = entries.get(key);
        return problem(
                entry.line(),
                entry.column(),
                key + " is " + MessageText.quoted(entry.text()) + "; expected " + allowed);
    }

    private FloorPlanException problem(int line, int column, String sentence) {
        return new FloorPlanException(file + ":" + line + ":" + column + ": " + sentence);
    }
}
