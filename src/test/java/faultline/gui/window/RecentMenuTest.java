package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** The texts of the menu of recent files, without a display. */
@ExtendWith(EdtChecker.class)
class RecentMenuTest {

    @Test
    void aLongNameIsShortenedSoThatTheMenuFitsOnASmallScreen() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            Map<String, String> texts = new HashMap<>();
            WindowPreferences preferences = new WindowPreferences(
                    new WindowPreferences.PreferenceStore(key -> texts.getOrDefault(key, ""), texts::put));
            Path file = Path.of("folder".repeat(30)).toAbsolutePath().resolve("scenario".repeat(25) + ".xml");
            preferences.recentFiles().add(file);
            JMenuItem item = new RecentMenu(preferences.recentFiles(), chosen -> {}).getItem(0);
            assertTrue(item.getText().startsWith("1  scenario"), item.getText());
            assertTrue(
                    item.getPreferredSize().width < 800, item.getPreferredSize().toString());
            assertEquals(file.toString(), item.getToolTipText());
        });
    }
}
