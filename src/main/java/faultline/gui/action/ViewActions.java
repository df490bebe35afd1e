package faultline.gui.action;

import static faultline.gui.action.Keystrokes.menuCharacter;
import static faultline.gui.action.Keystrokes.menuShiftShortcut;
import static faultline.gui.action.Keystrokes.menuShortcut;
import static faultline.gui.action.Keystrokes.unmodified;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Glyph;
import faultline.paint.scene.Layer;
import faultline.paint.scene.PathStyle;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;

/** The actions of the view: zoom, layers and following. */
public final class ViewActions {

    private ViewActions() {}

    public static void addTo(ActionRegistry actions, SimulationCanvas canvas) {
        actions.add(UiAction.of("fit", canvas::fit)
                .withAccelerator(menuShortcut(KeyEvent.VK_0))
                .withIcon(Glyph.FIT));
        actions.add(UiAction.of("zoomIn", canvas::zoomIn).withAccelerator(menuCharacter('+')));
        actions.add(UiAction.of("zoomOut", canvas::zoomOut).withAccelerator(menuCharacter('-')));
        actions.add(UiAction.toggle("follow", false, canvas::setFollowing)
                .withAccelerator(unmodified(KeyEvent.VK_F))
                .withIcon(Glyph.FOLLOW));
        actions.add(UiAction.of("measure", canvas.tools()::measure).withAccelerator(unmodified(KeyEvent.VK_M)));
        actions.add(layer("path", canvas, Layer.PATH)
                .withAccelerator(unmodified(KeyEvent.VK_P))
                .withIcon(Glyph.PATH));
        actions.add(layer("cones", canvas, Layer.CONES).withAccelerator(unmodified(KeyEvent.VK_C)));
        actions.add(layer("hits", canvas, Layer.INTERSECTIONS));
        actions.add(layer("routes", canvas, Layer.ROUTES));
        actions.add(layer("labels", canvas, Layer.LABELS));
        actions.add(layer("grid", canvas, Layer.GRID).withAccelerator(unmodified(KeyEvent.VK_G)));
        actions.add(layer("scaleBar", canvas, Layer.SCALE_BAR));
    }

    /** Binds the keys that type plus and minus on different keyboards. */
    public static void bindTo(JRootPane root, ActionRegistry actions) {
        bind(
                root,
                actions.get("zoomIn"),
                menuShortcut(KeyEvent.VK_PLUS),
                menuShortcut(KeyEvent.VK_EQUALS),
                menuShiftShortcut(KeyEvent.VK_EQUALS),
                menuShortcut(KeyEvent.VK_ADD));
        bind(root, actions.get("zoomOut"), menuShortcut(KeyEvent.VK_MINUS), menuShortcut(KeyEvent.VK_SUBTRACT));
    }

    private static void bind(JRootPane root, UiAction action, KeyStroke... strokes) {
        for (KeyStroke stroke : strokes) {
            root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, action.key());
        }
        root.getActionMap().put(action.key(), action);
    }

    /** Adds the actions that choose what colours the path; the choice is remembered. */
    public static void addPathColours(ActionRegistry actions, SimulationCanvas canvas, WindowPreferences preferences) {
        addPathColour(actions, canvas, preferences, "pathStates", Layer.PATH_STATES, PathStyle.STATES);
        addPathColour(actions, canvas, preferences, "pathFaults", Layer.PATH_FAULTS, PathStyle.FAULTS);
    }

    private static void addPathColour(
            ActionRegistry actions,
            SimulationCanvas canvas,
            WindowPreferences preferences,
            String key,
            Layer layer,
            PathStyle style) {
        boolean chosen = preferences.get(Preference.PATH_STYLE) == style;
        canvas.setLayer(layer, chosen);
        actions.add(UiAction.toggle(key, chosen, on -> {
            for (Layer colour : List.of(Layer.PATH_STATES, Layer.PATH_FAULTS)) {
                canvas.setLayer(colour, on && colour == layer);
            }
            actions.get("pathStates").setOn(on && style == PathStyle.STATES);
            actions.get("pathFaults").setOn(on && style == PathStyle.FAULTS);
            preferences.set(Preference.PATH_STYLE, on ? style : PathStyle.RUN);
        }));
    }

    private static UiAction layer(String key, SimulationCanvas canvas, Layer layer) {
        return UiAction.toggle(key, canvas.isLayerOn(layer), on -> canvas.setLayer(layer, on));
    }
}
