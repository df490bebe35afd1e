package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.TitledSection;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.util.List;
import javax.swing.Action;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JPanel;

/**
 * The controller's kind and settings, and the drive that it commands. For a controller that the user has chosen, or
 * that the scenario needs from outside, also what the user has chosen and how to choose another one.
 */
public final class ControllerPanel extends JPanel {

    private final transient CommandSender sender;
    private final transient ControllerForm form = new ControllerForm(this::send);
    private final DriveFields driveFields;
    private final ValueLabel chosen =
            new ValueLabel(() -> Messages.get("controller.chosen"), () -> List.of("a longer name"));
    private final TitledSection choice;
    private boolean isChosen;

    /** Creates a panel. The scenario editor receives changes of the robot's drive, which need a new simulation. */
    ControllerPanel(CommandSender sender, ScenarioEditor scenarioEditor, ControlPanel.PanelActions actions) {
        this.sender = sender;
        driveFields = new DriveFields(scenarioEditor);
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        choice = new TitledSection(createChoice(actions));
        form.sections().forEach(this::add);
        add(choice, 1);
        setChosen("");
        add(new TitledSection("controller.drive", driveFields));
        form.setController(ControllerSpec.WallFollowing.DEFAULT, RobotSpec.DEFAULT, SimulationSetup.DEFAULT_TICK);
        choice.setVisible(false);
        driveFields.setRobot(RobotSpec.DEFAULT);
    }

    private JPanel createChoice(ControlPanel.PanelActions actions) {
        JPanel choiceForm = new JPanel(new WrappingGridLayout());
        choiceForm.add(
                UiText.tip(FormConstraints.label("controller.chosen", chosen), "controller.chosen.tip"),
                FormConstraints.cell(0, 0));
        choiceForm.add(chosen, FormConstraints.fillRow(1, 0));
        addButton(choiceForm, 1, actions.chooseController());
        addButton(choiceForm, 2, actions.scenarioController());
        return choiceForm;
    }

    /** Adds a button without the mnemonic of its action, which belongs to a menu. */
    private static void addButton(JPanel form, int row, Action action) {
        GridBagConstraints cell = FormConstraints.fillRow(1, row);
        cell.fill = GridBagConstraints.NONE;
        form.add(RefreshSteps.add(new JButton(action), button -> button.setMnemonic(0)), cell);
    }

    /** Shows the name or the command of the controller that the user has chosen; empty for none. */
    void setChosen(String text) {
        chosen.setValue(text.isEmpty() ? ValueLabel.NONE : text);
        chosen.setToolTipText(text.isEmpty() ? null : text);
        isChosen = !text.isEmpty();
    }

    private void send(ControllerSpec.BuiltIn changed) {
        sender.send(new Command.ConfigureController(changed));
    }

    /** Shows a controller, the name that it gives itself, empty for none, and the drive of a setup's robot. */
    void setSettings(ControllerSpec current, String name, SimulationSetup setup) {
        assert EventQueue.isDispatchThread();
        form.setName(name);
        choice.setVisible(isChosen || !(current instanceof ControllerSpec.BuiltIn));
        sender.pendingEdits().setController(current);
        form.setController(
                sender.pendingEdits().controller(), sender.pendingEdits().robot(), setup.dt());
        driveFields.setRobot(setup.robot());
    }
}
