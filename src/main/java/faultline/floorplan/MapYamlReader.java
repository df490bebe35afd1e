package faultline.floorplan;

import faultline.io.ByteCount;
import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.ProblemKind;
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
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads the YAML files of ROS map_server: one mapping, in lines or in braces, of plain or quoted scalars, and
 * {@code origin} as a list in brackets or in lines. Keys that map_server does not know are ignored, with a note on
 * those that may be misspelt.
 */
final class MapYamlReader {

    private static final long MAX_BYTES = 1 << 20;
    /** The maximum yaw, which is less than the greatest heading of an obstacle, a million degrees. */
    private static final double MAX_YAW = 17_000;

    private static final int MAX_SHOWN_PATH = 1000;

    /** The control characters that are not allowed in a file; a form feed is a blank, although YAML forbids it. */
    private static final Pattern CONTROL = Pattern.compile("[\\p{Cntrl}\\x80-\\x9F&&[^\\t\\n\\r\\f\\x85]]");

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
        return parsed(file).toDescription();
    }

    /** Returns a note on each unknown key that may be a misspelling of a known one. */
    static List<Message> readNotes(Path file) throws FloorPlanException {
        List<Message> notes = new ArrayList<>();
        for (String given : parsed(file).entries.keySet()) {
            if (!KEYS.contains(given)) {
                DidYouMean.nearest(given, KEYS)
                        .map(known -> FloorPlanProblem.UNKNOWN_KEY.with(MessageText.excerpt(given), known))
                        .ifPresent(notes::add);
            }
        }
        return notes;
    }

    private static MapYamlReader parsed(Path file) throws FloorPlanException {
        MapYamlReader reader = new MapYamlReader(file);
        reader.parse(readText(file).replaceFirst("^\uFEFF", ""));
        return reader;
    }

    private static String readText(Path file) throws FloorPlanException {
        try {
            if (Files.notExists(file)) {
                throw new FloorPlanException(file, ProblemKind.NO_SUCH_FILE.with());
            }
            if (!Files.isReadable(file)) {
                throw new FloorPlanException(file, ProblemKind.UNREADABLE_FILE.with());
            }
            if (!Files.isRegularFile(file)) {
                throw new FloorPlanException(file, ProblemKind.IRREGULAR_FILE.with(FloorPlanProblem.MAP_FILE.with()));
            }
            if (Files.size(file) > MAX_BYTES) {
                throw new FloorPlanException(
                        file,
                        ProblemKind.TOO_MANY_BYTES.with(
                                ByteCount.format(Files.size(file)), ByteCount.format(MAX_BYTES)));
            }
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (CharacterCodingException e) {
            throw new FloorPlanException(file, FloorPlanProblem.NOT_UTF_8.with());
        } catch (FloorPlanException e) {
            throw e;
        } catch (IOException e) {
            throw new FloorPlanException(file, ProblemKind.UNREADABLE_FILE.with());
        }
    }

    private void parse(String text) throws FloorPlanException {
        requirePrintable(text);
        String listKey = "";
        for (MapYamlLines.YamlLine line : MapYamlLines.of(text, KEYS)) {
            String content = line.text().strip();
            if (MapYamlLines.isItem(content) && entries.containsKey(listKey)) {
                entries.get(listKey)
                        .values()
                        .add(MapYamlScalar.read(content.substring(1).strip()));
            } else if (content.startsWith("{") && content.endsWith("}")) {
                parseBraces(line.number(), line.text());
            } else if (!isMark(line.text())) {
                listKey = parseEntry(line.number(), 1, line.text());
            }
        }
    }

    /** Throws an exception at the first control character; with one in its name, a key would be ignored as unknown. */
    private void requirePrintable(String text) throws FloorPlanException {
        Matcher control = CONTROL.matcher(text);
        if (control.find()) {
            String[] lines = text.substring(0, control.start()).split(MapYamlLines.LINE_BREAK, -1);
            throw problem(
                    lines.length,
                    lines[lines.length - 1].length() + 1,
                    FloorPlanProblem.CONTROL_CHARACTER.with(String.format(
                            Locale.ROOT, "%04X", (int) control.group().charAt(0))));
        }
    }

    /** Returns whether a line begins or ends a document. */
    private static boolean isMark(String line) {
        String content = line.strip();
        return content.equals("---") || content.equals("...") || line.startsWith("%");
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
            throw problem(lineNumber, firstColumn, FloorPlanProblem.LINE.with(MessageText.excerpt(line.strip())));
        }
        String key = MapYamlScalar.read(line.substring(0, colon).strip());
        String value = line.substring(colon + 1).strip();
        int column = line.length() - line.substring(colon + 1).stripLeading().length() + firstColumn;
        if (entries.containsKey(key)) {
            throw problem(lineNumber, firstColumn, FloorPlanProblem.DUPLICATE_KEY.with(MessageText.excerpt(key)));
        }
        entries.put(key, new YamlEntry(lineNumber, column, splitValue(value)));
        return key;
    }

    private static List<String> splitValue(String value) {
        List<String> values = new ArrayList<>();
        String content = MapYamlScalar.withoutProperties(value);
        if (content.startsWith("[") && content.endsWith("]")) {
            // YAML allows a comma after the last item.
            String items = content.substring(1, content.length() - 1).strip().replaceFirst(",$", "");
            for (String part : items.split(",", -1)) {
                values.add(MapYamlScalar.read(part.strip()));
            }
        } else if (!content.isEmpty()) {
            values.add(MapYamlScalar.read(value));
        }
        return values;
    }

    private MapDescription toDescription() throws FloorPlanException {
        Path image = imageFile();
        BigDecimal resolution = number("resolution", "0.05");
        if (!MapDescription.isResolution(resolution)) {
            throw wrong("resolution", FloorPlanProblem.RESOLUTION.with());
        }
        double occupied = share("occupied_thresh", "0.65");
        double free = share("free_thresh", "0.196");
        MapDescription description = new MapDescription(image, resolution, yaw(), mode(), isNegated(), occupied, free);
        if (!canBeImage(image)) {
            throw wrong("image", existingImage(image));
        }
        return description;
    }

    /** Returns whether a file is there. One in a folder without permission may be; it is reported when it is read. */
    private static boolean canBeImage(Path image) {
        boolean unknown = !Files.exists(image) && !Files.notExists(image);
        return Files.isRegularFile(image) || unknown && image.toString().length() <= MAX_SHOWN_PATH;
    }

    /** Returns the rule for the image, with its path unless that is too long for a message. */
    private static Message existingImage(Path image) {
        return image.toString().length() > MAX_SHOWN_PATH
                ? FloorPlanProblem.IMAGE_NAME.with()
                : (Files.exists(image) ? FloorPlanProblem.REGULAR_IMAGE : FloorPlanProblem.EXISTING_IMAGE)
                        .with(MessageText.oneLine(image.toString()));
    }

    private Path imageFile() throws FloorPlanException {
        String name = single("image");
        if (name.isEmpty()) {
            throw wrong("image", FloorPlanProblem.IMAGE_NAME.with());
        }
        try {
            return file.resolveSibling(name);
        } catch (InvalidPathException e) {
            throw wrong("image", FloorPlanProblem.IMAGE_NAME.with());
        }
    }

    private double yaw() throws FloorPlanException {
        if (!entries.containsKey("origin")) {
            return 0;
        }
        List<String> values = entries.get("origin").values();
        if (values.size() != 3) {
            throw wrong("origin", FloorPlanProblem.ORIGIN.with());
        }
        double[] numbers = new double[3];
        for (int i = 0; i < 3; i++) {
            Optional<BigDecimal> number = DecimalText.parse(values.get(i));
            numbers[i] = number.isEmpty() ? Double.NaN : number.get().doubleValue();
        }
        if (!Arrays.stream(numbers).allMatch(Double::isFinite)) {
            throw wrong("origin", FloorPlanProblem.ORIGIN.with());
        }
        if (Math.abs(numbers[2]) > MAX_YAW) {
            throw wrong("origin", FloorPlanProblem.YAW.with(DecimalText.format(MAX_YAW)));
        }
        return numbers[2];
    }

    private MapMode mode() throws FloorPlanException {
        if (!entries.containsKey("mode")) {
            return MapMode.TRINARY;
        }
        String name = single("mode");
        for (MapMode mode : MapMode.values()) {
            if (mode.fileName().equalsIgnoreCase(name)) {
                return mode;
            }
        }
        List<String> names =
                Arrays.stream(MapMode.values()).map(MapMode::fileName).toList();
        throw wrong("mode", Allowed.names(names, name));
    }

    private boolean isNegated() throws FloorPlanException {
        if (!entries.containsKey("negate")) {
            return false;
        }
        return switch (single("negate").toLowerCase(Locale.ROOT)) {
            case "0", "false", "no", "off" -> false;
            case "1", "true", "yes", "on" -> true;
            default -> throw wrong("negate", FloorPlanProblem.NEGATE.with());
        };
    }

    private double share(String key, String defaultText) throws FloorPlanException {
        double value = number(key, defaultText).doubleValue();
        if (value < 0 || value > 1) {
            throw wrong(key, FloorPlanProblem.SHARE.with());
        }
        return value;
    }

    private BigDecimal number(String key, String defaultText) throws FloorPlanException {
        if (key.equals("resolution") || entries.containsKey(key)) {
            Optional<BigDecimal> number = DecimalText.parse(single(key));
            if (number.isEmpty() || !Double.isFinite(number.get().doubleValue())) {
                throw wrong(key, FloorPlanProblem.NUMBER.with());
            }
            return number.get();
        }
        return new BigDecimal(defaultText);
    }

    private String single(String key) throws FloorPlanException {
        if (!entries.containsKey(key)) {
            throw problem(1, 1, missing(key));
        }
        if (entries.get(key).values().size() != 1) {
            throw wrong(key, FloorPlanProblem.ONE_VALUE.with());
        }
        return entries.get(key).values().get(0);
    }

    /** Returns the problem of a missing key, with an unknown key that may be a misspelling of it. */
    private Message missing(String key) {
        return entries.keySet().stream()
                .filter(given -> DidYouMean.nearest(given, List.of(key)).isPresent())
                .findFirst()
                .map(given -> FloorPlanProblem.MISSPELT_KEY.with(key, MessageText.excerpt(given)))
                .orElseGet(() -> FloorPlanProblem.MISSING_KEY.with(key));
    }

    private FloorPlanException wrong(String key, Message allowed) {
        YamlEntry entry = entries.get(key);
        return problem(
                entry.line(),
                entry.column(),
                FloorPlanProblem.VALUE.with(key, MessageText.excerpt(entry.text()), allowed));
    }

    private FloorPlanException problem(int line, int column, Message message) {
        return new FloorPlanException(file, line, column, message);
    }
}
