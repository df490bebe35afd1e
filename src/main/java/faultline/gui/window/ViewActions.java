package faultline.gui.window;

import static faultline.gui.action.Keystrokes.menu;
import static faultline.gui.action.Keystrokes.menuShift;
import static faultline.gui.action.Keystrokes.menuSign;
import static faultline.gui.action.Keystrokes.plain;

import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.theme.Glyph;
import faultline.paint.Layer;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;

/** The actions on what is shown: zoom, layers and following. */
final class ViewActions {

    private ViewActions() {
    }

    static void addTo(UiActions actions, SimulationCanvas canvas) {
        actions.add(UiAction.of("fit", canvas::fit).on(menu(KeyEvent.VK_0)).drawn(Glyph.FIT));
        actions.add(UiAction.of("zoomIn", canvas::zoomIn).on(menuSign('+')));
        actions.add(UiAction.of("zoomOut", canvas::zoomOut).on(menuSign('-')));
        actions.add(UiAction.toggle("follow", false, canvas::setFollowing).on(plain(KeyEvent.VK_F)).drawn(Glyph.FOLLOW));
        actions.add(UiAction.of("measure", canvas.tools()::measure).on(plain(KeyEvent.VK_M)));
        actions.add(layer("path", canvas, Layer.PATH).on(plain(KeyEvent.VK_P)).drawn(Glyph.PATH));
        actions.add(layer("cones", canvas, Layer.CONES).on(plain(KeyEvent.VK_C)));
        actions.add(layer("hits", canvas, Layer.HITS));
        actions.add(layer("routes", canvas, Layer.ROUTES));
        actions.add(layer("labels", canvas, Layer.LABELS));
        actions.add(layer("grid", canvas, Layer.GRID).on(plain(KeyEvent.VK_G)));
        actions.add(layer("scaleBar", canvas, Layer.SCALE_BAR));
    }

    /** The keys that are plus and minus on one keyboard or another. */
    static void bindTo(JRootPane root, UiActions actions) {
        bind(root, actions.get("zoomIn"), menu(KeyEvent.VK_PLUS), menu(KeyEvent.VK_EQUALS), menuShift(KeyEvent.VK_EQUALS), menu(KeyEvent.VK_ADD));
        bind(root, actions.get("zoomOut"), menu(KeyEvent.VK_MINUS), menu(KeyEvent.VK_SUBTRACT));
    }

    private static void bind(JRootPane root, UiAction action, KeyStroke... strokes) {
        for (KeyStroke stroke : strokes) {
            root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, action.key());
        }
        root.getActionMap().put(action.key(), action);
    }

    private static UiAction layer(String key, SimulationCanvas canvas, Layer layer) {
        return UiAction.toggle(key, canvas.isLayerOn(layer), on -> canvas.setLayer(layer, on));
    }
}
