package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class ControllerFormTest {

    private final List<ControllerSpec> changes = new ArrayList<>();

    /** In a dialog nothing would show the present kind again after such a choice. */
    @Test
    void anExternalControllerIsListedOnlyWhileItIsShown() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            ControllerForm form = new ControllerForm(changes::add);
            JComboBox<?> kind = ComponentFinder.find(form.sections().get(0), JComboBox.class, "Controller");
            for (int pass = 0; pass < 2; pass++) {
                show(form, ControllerSpec.WallFollowing.DEFAULT);
                assertEquals(List.of("FOLLOWER", "DRIVE", "NONE"), items(kind));
                assertEquals("FOLLOWER", String.valueOf(kind.getSelectedItem()));
                assertTrue(kind.isEnabled());
                show(form, new ControllerSpec.Extern(0.02));
                show(form, new ControllerSpec.Extern(0.02));
                assertEquals("FOREIGN", String.valueOf(kind.getSelectedItem()));
                assertFalse(kind.isEnabled());
            }
            assertEquals(List.of(), changes, "nothing was chosen");
            show(form, ControllerSpec.WallFollowing.DEFAULT);
            kind.setSelectedIndex(2);
            assertEquals(List.of(new ControllerSpec.None()), changes);
        });
    }

    private static void show(ControllerForm form, ControllerSpec controller) {
        form.setController(controller, RobotSpec.DEFAULT, SimulationSetup.DEFAULT_TICK);
    }

    private static List<String> items(JComboBox<?> box) {
        return IntStream.range(0, box.getItemCount())
                .mapToObj(index -> String.valueOf(box.getItemAt(index)))
                .toList();
    }
}
