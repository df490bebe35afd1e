package faultline.gui.window;

import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Theme;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** The switch between the light theme and the dark one. */
final class ThemeSwitch {

    private final JFrame window;
    private final SimulationCanvas canvas;
    private final WindowMemory memory;
    private final UiAction dark = UiAction.toggle("dark", Theme.current() == Theme.DARK, on -> choose(on ? Theme.DARK : Theme.LIGHT));

    ThemeSwitch(JFrame window, SimulationCanvas canvas, WindowMemory memory) {
        this.window = window;
        this.canvas = canvas;
        this.memory = memory;
        draw();
    }

    UiAction action() {
        return dark;
    }

    private void choose(Theme theme) {
        theme.install();
        draw();
        canvas.setPalette(theme.palette());
        SwingUtilities.updateComponentTreeUI(window);
        memory.keepTheme(theme);
    }

    /** Shows what a press would bring. */
    private void draw() {
        dark.drawn(Theme.current() == Theme.DARK ? Glyph.SUN : Glyph.MOON);
    }
}
