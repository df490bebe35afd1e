package faultline.gui.settings;

import faultline.gui.text.Language;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeChoice;
import faultline.paint.scene.PathStyle;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** A preference of the window: the key of its stored text, which is empty or damaged for the default value. */
public record Preference<T>(String key, Function<String, T> reader, Function<T, String> writer) {

    /** The theme. */
    public static final Preference<ThemeChoice> THEME = ofEnum("theme", ThemeChoice.LIGHT);
    /** The language. */
    public static final Preference<Language> LANGUAGE = ofEnum("language", Language.ENGLISH);
    /** The text size. */
    public static final Preference<TextSize> TEXT_SIZE = ofEnum("textSize", TextSize.NORMAL);
    /** What colours the path of the run. */
    public static final Preference<PathStyle> PATH_STYLE = ofEnum("path.style", PathStyle.RUN);
    /** Whether the gallery is shown at start, true by default. */
    public static final Preference<Boolean> GALLERY_SHOWN = visibility("gallery");
    /** Whether the fault time line is visible, true by default. */
    public static final Preference<Boolean> TIMELINE_SHOWN = visibility("timeline");
    /** Whether the control panel is visible, true by default. */
    public static final Preference<Boolean> PANEL_SHOWN = visibility("panel");
    /** Whether the user has shown or hidden the instruments; empty if they have done neither. */
    public static final Preference<Optional<Boolean>> DOCK_SHOWN = new Preference<>(
            "dock.hidden",
            hidden -> hidden.isEmpty() ? Optional.empty() : Optional.of(!Boolean.parseBoolean(hidden)),
            shown -> shown.map(now -> Boolean.toString(!now)).orElse(""));
    /** Whether positions snap to the grid. */
    public static final Preference<Boolean> SNAP_GRID = ofBoolean("snap.grid");
    /** Whether headings snap. */
    public static final Preference<Boolean> SNAP_ANGLE = ofBoolean("snap.angle");
    /** Whether the window fills the screen. */
    public static final Preference<Boolean> MAXIMISED = ofBoolean("maximised");
    /** The bounds of the window, empty if they are not known. */
    public static final Preference<Optional<Rectangle>> BOUNDS =
            new Preference<>("bounds", Preference::parseBounds, bounds -> bounds.map(
                            at -> at.x + " " + at.y + " " + at.width + " " + at.height)
                    .orElse(""));
    /** The width of the control panel, pixels, empty if it is not known. */
    public static final Preference<Optional<Integer>> PANEL_WIDTH = ofPixels("divider");
    /** The height of the instruments, pixels, empty if it is not known. */
    public static final Preference<Optional<Integer>> DOCK_HEIGHT = ofPixels("dock");
    /** The height of the lanes of the time line, pixels, empty if the user has not chosen it. */
    public static final Preference<Optional<Integer>> LANES_HEIGHT = ofPixels("lanes");
    /** The width of the strip chart, pixels, empty if it is not known. */
    public static final Preference<Optional<Integer>> CHART_WIDTH = ofPixels("chart");

    private static final String HIDDEN = "hidden";

    private static <E extends Enum<E>> Preference<E> ofEnum(String key, E otherwise) {
        return new Preference<>(
                key,
                name -> Stream.of(otherwise.getDeclaringClass().getEnumConstants())
                        .filter(option -> option.name().equals(name))
                        .findFirst()
                        .orElse(otherwise),
                Enum::name);
    }

    private static Preference<Boolean> ofBoolean(String key) {
        return new Preference<>(key, Boolean::parseBoolean, value -> Boolean.toString(value));
    }

    private static Preference<Boolean> visibility(String key) {
        return new Preference<>(key, text -> !text.equals(HIDDEN), shown -> shown ? "" : HIDDEN);
    }

    /** Returns a length, which is stored as at the normal text size, because the user may choose another size. */
    private static Preference<Optional<Integer>> ofPixels(String key) {
        return new Preference<>(
                key,
                text -> Optional.of(text)
                        .filter(number -> number.matches("\\d{1,5}"))
                        .map(number -> TextSize.scaled(Integer.parseInt(number))),
                pixels -> pixels.map(now -> Integer.toString(TextSize.unscaled(now)))
                        .orElse(""));
    }

    private static Optional<Rectangle> parseBounds(String text) {
        try {
            List<Integer> numbers =
                    Stream.of(text.split(" ")).map(Integer::valueOf).toList();
            return numbers.size() == 4
                    ? Optional.of(new Rectangle(numbers.get(0), numbers.get(1), numbers.get(2), numbers.get(3)))
                    : Optional.empty();
        } catch (NumberFormatException damaged) {
            return Optional.empty();
        }
    }
}
