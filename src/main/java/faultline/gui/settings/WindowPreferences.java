package faultline.gui.settings;

import faultline.gui.text.Language;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeChoice;
import faultline.paint.scene.PathStyle;
import java.awt.Rectangle;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;
import java.util.stream.Stream;

/**
 * The preferences of the window. If the system has no preference store, nothing is remembered and nothing else changes.
 */
public final class WindowPreferences {

    /**
     * The platform's messages about preferences are of no use to a user. Held in a field, because a logger that is
     * garbage collected loses its level.
     */
    private static final Logger PREFERENCES_LOG = Logger.getLogger("java.util.prefs");

    private static final String THEME = "theme";
    private static final String BOUNDS = "bounds";
    private static final String MAXIMISED = "maximised";
    private static final String DIVIDER = "divider";
    private static final String LANGUAGE = "language";
    private static final String TEXT_SIZE = "textSize";
    private static final String GALLERY = "gallery";
    private static final String HIDDEN = "hidden";
    private static final String SNAP_GRID = "snap.grid";
    private static final String SNAP_ANGLE = "snap.angle";
    private static final String DOCK = "dock";
    private static final String CHART = "chart";
    private static final String DOCK_HIDDEN = "dock.hidden";
    private static final String TIMELINE = "timeline";
    private static final String PANEL = "panel";
    private static final String PATH_STYLE = "path.style";

    private final PreferenceStore store;

    /** A store of texts by key; an empty text if there is none. */
    public record PreferenceStore(UnaryOperator<String> getter, BiConsumer<String, String> setter) {
        String get(String key) {
            return getter.apply(key);
        }

        void put(String key, String text) {
            setter.accept(key, text);
        }
    }

    public WindowPreferences(PreferenceStore store) {
        this.store = store;
    }

    /** Returns the preferences of the current user; they are not stored if the system has no preference store. */
    public static WindowPreferences forCurrentUser() {
        PREFERENCES_LOG.setLevel(Level.OFF);
        try {
            return new WindowPreferences(
                    WrittenPreferences.storeOf(Preferences.userRoot().node("faultline/window")));
        } catch (IllegalStateException | SecurityException unavailable) {
            return nonPersistent();
        }
    }

    /** Returns preferences that are not stored. */
    public static WindowPreferences nonPersistent() {
        return new WindowPreferences(new PreferenceStore(key -> "", (key, text) -> {}));
    }

    /** Returns the chosen theme, light by default. */
    public ThemeChoice themeChoice() {
        return readEnum(THEME, ThemeChoice.class, ThemeChoice.LIGHT);
    }

    public void setThemeChoice(ThemeChoice choice) {
        store.put(THEME, choice.name());
    }

    /** Returns the chosen language, English by default. */
    public Language language() {
        return readEnum(LANGUAGE, Language.class, Language.ENGLISH);
    }

    public void setLanguage(Language language) {
        store.put(LANGUAGE, language.name());
    }

    /** Returns the chosen text size, normal by default. */
    public TextSize textSize() {
        return readEnum(TEXT_SIZE, TextSize.class, TextSize.NORMAL);
    }

    public void setTextSize(TextSize size) {
        store.put(TEXT_SIZE, size.name());
    }

    private <E extends Enum<E>> E readEnum(String key, Class<E> options, E otherwise) {
        String name = store.get(key);
        return Stream.of(options.getEnumConstants())
                .filter(option -> option.name().equals(name))
                .findFirst()
                .orElse(otherwise);
    }

    /** Returns whether the gallery is shown at start, true by default. */
    public boolean isGalleryShownAtStart() {
        return !store.get(GALLERY).equals(HIDDEN);
    }

    public void setGalleryShownAtStart(boolean shown) {
        store.put(GALLERY, shown ? "" : HIDDEN);
    }

    /** Returns whether positions snap to the grid. */
    public boolean isGridSnapped() {
        return Boolean.parseBoolean(store.get(SNAP_GRID));
    }

    /** Returns whether headings snap. */
    public boolean isAngleSnapped() {
        return Boolean.parseBoolean(store.get(SNAP_ANGLE));
    }

    public void setSnap(boolean grid, boolean angle) {
        store.put(SNAP_GRID, Boolean.toString(grid));
        store.put(SNAP_ANGLE, Boolean.toString(angle));
    }

    public RecentFiles recentFiles() {
        return new RecentFiles(store);
    }

    /** Returns the bounds of the window, or empty if they are not known. */
    public Optional<Rectangle> bounds() {
        String[] numbers = store.get(BOUNDS).split(" ");
        try {
            return numbers.length == 4
                    ? Optional.of(new Rectangle(
                            Integer.parseInt(numbers[0]),
                            Integer.parseInt(numbers[1]),
                            Integer.parseInt(numbers[2]),
                            Integer.parseInt(numbers[3])))
                    : Optional.empty();
        } catch (NumberFormatException damaged) {
            return Optional.empty();
        }
    }

    public void setBounds(Rectangle bounds) {
        store.put(BOUNDS, bounds.x + " " + bounds.y + " " + bounds.width + " " + bounds.height);
    }

    /** Returns whether the window fills the screen, false by default. */
    public boolean isMaximised() {
        return Boolean.parseBoolean(store.get(MAXIMISED));
    }

    public void setMaximised(boolean maximised) {
        store.put(MAXIMISED, Boolean.toString(maximised));
    }

    /** Returns the width of the control panel in pixels at the installed text size, or empty if it is not known. */
    public Optional<Integer> panelWidth() {
        return readPixels(DIVIDER);
    }

    public void setPanelWidth(int width) {
        storePixels(DIVIDER, width);
    }

    /** Returns the height of the instruments in pixels, or empty if it is not known. */
    public Optional<Integer> dockHeight() {
        return readPixels(DOCK);
    }

    /** Returns the width of the strip chart in pixels, or empty if it is not known. */
    public Optional<Integer> chartWidth() {
        return readPixels(CHART);
    }

    /** Returns whether the user has shown or hidden the instruments; empty if they have done neither. */
    public Optional<Boolean> dockShown() {
        String hidden = store.get(DOCK_HIDDEN);
        return hidden.isEmpty() ? Optional.empty() : Optional.of(!Boolean.parseBoolean(hidden));
    }

    public void setDockShown(boolean shown) {
        store.put(DOCK_HIDDEN, Boolean.toString(!shown));
    }

    /** Returns whether the control panel is visible, true by default. */
    public boolean isPanelShown() {
        return !store.get(PANEL).equals(HIDDEN);
    }

    public void setPanelShown(boolean shown) {
        store.put(PANEL, shown ? "" : HIDDEN);
    }

    public void setDock(int height, int chartWidth) {
        storePixels(DOCK, height);
        storePixels(CHART, chartWidth);
    }

    /** Returns whether the fault time line is visible, true by default. */
    public boolean isTimelineShown() {
        return !store.get(TIMELINE).equals(HIDDEN);
    }

    public void setTimelineShown(boolean shown) {
        store.put(TIMELINE, shown ? "" : HIDDEN);
    }

    /** Returns what colours the path of the run, nothing by default. */
    public PathStyle pathStyle() {
        return readEnum(PATH_STYLE, PathStyle.class, PathStyle.RUN);
    }

    public void setPathStyle(PathStyle style) {
        store.put(PATH_STYLE, style.name());
    }

    private Optional<Integer> readPixels(String key) {
        String text = store.get(key);
        return text.matches("\\d{1,5}") ? Optional.of(TextSize.scaled(Integer.parseInt(text))) : Optional.empty();
    }

    /** Stores a length as it would be at the normal text size, because the user may choose another size. */
    private void storePixels(String key, int pixels) {
        store.put(key, Integer.toString(TextSize.unscaled(pixels)));
    }
}
