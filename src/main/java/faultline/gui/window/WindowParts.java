package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.JFrame;

/** The parts of the window that the user shows and hides: the instruments, the control panel and the time line. */
final class WindowParts {

    /** The height of a window that shows the instruments by default, pixels at the normal text size. */
    private static final int MIN_HEIGHT_WITH_DOCK = 700;
    /** The part of that height that grows with the text. */
    private static final int TEXT_HEIGHT_WITH_DOCK = 520;

    private final WindowPreferences preferences;
    private final UiAction instruments = UiAction.toggle("instruments", true, this::setDockShown)
            .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_I));
    private final UiAction controlPanel;
    private final UiAction timeline;
    private MainPanel mainPanel;
    /** Whether the user has shown or hidden the instruments in this window. */
    private boolean dockChosen;

    /** Creates the actions that show and hide the parts. */
    WindowParts(WindowPreferences preferences) {
        this.preferences = preferences;
        controlPanel = UiAction.toggle("controlPanel", preferences.get(Preference.PANEL_SHOWN), this::setPanelShown)
                .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_F9));
        timeline = UiAction.toggle("timeline", preferences.get(Preference.TIMELINE_SHOWN), this::setTimelineShown)
                .withAccelerator(Keystrokes.unmodified(KeyEvent.VK_T));
    }

    void addTo(ActionRegistry actions) {
        actions.add(instruments);
        actions.add(controlPanel);
        actions.add(timeline);
    }

    /** Shows the parts of the contents of a window that the user has chosen. */
    void install(JFrame window, MainPanel contents) {
        mainPanel = contents;
        mainPanel.dividers().setPanelShown(preferences.get(Preference.PANEL_SHOWN));
        mainPanel.dividers().setLanesShown(preferences.get(Preference.TIMELINE_SHOWN));
        RefreshSteps.add(window.getRootPane(), root -> showDockByDefault(window));
        window.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                showDockByDefault(window);
            }
        });
    }

    /** Shows the instruments as the user has chosen, otherwise in a window that is high enough. */
    private void showDockByDefault(JFrame window) {
        if (!dockChosen) {
            boolean shown = preferences.get(Preference.DOCK_SHOWN).orElse(window.getHeight() >= minHeightWithDock());
            mainPanel.dividers().setDockShown(shown);
            instruments.setOn(shown);
        }
    }

    private static int minHeightWithDock() {
        return MIN_HEIGHT_WITH_DOCK - TEXT_HEIGHT_WITH_DOCK + TextSize.scaled(TEXT_HEIGHT_WITH_DOCK);
    }

    /** Shows the time line and the control panel; a window that is not high hides the instruments, for the card. */
    void showForTour() {
        if (mainPanel.getRootPane().getHeight() < minHeightWithDock()) {
            mainPanel.dividers().setDockShown(false);
            instruments.setOn(false);
        }
        showTimeline();
        setPanelShown(true);
        controlPanel.setOn(true);
    }

    /** Shows the time line. */
    void showTimeline() {
        setTimelineShown(true);
        timeline.setOn(true);
    }

    private void setDockShown(boolean shown) {
        dockChosen = true;
        mainPanel.dividers().setDockShown(shown);
        preferences.set(Preference.DOCK_SHOWN, Optional.of(shown));
    }

    private void setPanelShown(boolean shown) {
        mainPanel.dividers().setPanelShown(shown);
        preferences.set(Preference.PANEL_SHOWN, shown);
    }

    private void setTimelineShown(boolean shown) {
        mainPanel.dividers().setLanesShown(shown);
        preferences.set(Preference.TIMELINE_SHOWN, shown);
    }
}
