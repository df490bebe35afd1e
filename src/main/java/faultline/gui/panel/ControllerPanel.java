package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.EventQueue;
import javax.swing.BoxLayout;
import javax.swing.JPanel;

/** The controller's kind and settings, and the drive that it commands. */
public final class ControllerPanel extends JPanel {

    private final transient UndoController editor;
    private final transient ControllerForm form = new ControllerForm(this::send);
    private final DriveFields driveFields;

    /** Creates a panel. The second editor receives changes of the robot's drive, which need a new simulation. */
    ControllerPanel(UndoController editor, ScenarioEditor scenarioEditor) {
        this.editor = editor;
        driveFields = new DriveFields(scenarioEditor);
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        form.sections().forEach(this::add);
        add(new TitledSection("controller.drive", driveFields));
        form.setController(ControllerSpec.WallFollowing.DEFAULT, RobotSpec.DEFAULT, SimulationSetup.DEFAULT_TICK);
        driveFields.setRobot(RobotSpec.DEFAULT);
    }

    private void send(ControllerSpec.BuiltIn changed) {
        editor.send(new Command.ConfigureController(changed));
    }

    /** Shows a controller, the name that it gives itself, empty for none, and the drive of a setup's robot. */
    void setSettings(ControllerSpec current, String name, SimulationSetup setup) {
        assert EventQueue.isDispatchThread();
        form.setName(name);
        editor.pendingEdits().setController(current);
        form.setController(
                editor.pendingEdits().controller(), editor.pendingEdits().robot(), setup.dt());
        driveFields.setRobot(setup.robot());
    }
}
