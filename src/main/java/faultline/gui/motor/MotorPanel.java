package faultline.gui.motor;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.panel.FaultList;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.robot.MotorSide;
import faultline.world.Snapshot;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;

/** Buttons that add a fault to the motors of a side, and below them, where it can grow, the list of active faults. */
public final class MotorPanel extends JPanel {

    private static final int LIST_GAP = 4;

    private final FaultList faults;
    private final List<JButton> buttons = new ArrayList<>();

    /**
     * Creates a panel without faults, disabled until there is a run. The sender receives repairs, and {@code addFault}
     * the side for which it asks for a fault.
     */
    public MotorPanel(CommandSender sender, Consumer<MotorSide> addFault) {
        super(new BorderLayout(0, LIST_GAP));
        faults = new FaultList(sender);
        JPanel row = new JPanel(new WrappingGridLayout());
        row.add(UiText.label("motors.add"), FormConstraints.cell(0, 0));
        for (MotorSide side : MotorSide.values()) {
            JButton button = createButton(side);
            button.addActionListener(event -> addFault.accept(side));
            buttons.add(button);
            GridBagConstraints cell = FormConstraints.cell(buttons.size(), 0);
            // The last column takes the room that is left.
            cell.weightx = buttons.size() == MotorSide.values().length ? 1 : 0;
            row.add(button, cell);
        }
        add(row, BorderLayout.NORTH);
        add(faults, BorderLayout.CENTER);
    }

    private static JButton createButton(MotorSide side) {
        JButton button = UiText.button("motors.add." + side.fileName());
        button.setEnabled(false);
        return RefreshSteps.add(button, self -> {
            self.setToolTipText(Messages.get("motors.add.tip", FaultText.motors(side)));
            self.getAccessibleContext().setAccessibleName(self.getToolTipText());
        });
    }

    /** Shows the faults of a world, given the timeline of its run; the same list as before if it is equal. */
    public void setSnapshot(Snapshot world, List<TimedCommand> timeline) {
        assert EventQueue.isDispatchThread();
        buttons.forEach(button -> button.setEnabled(true));
        faults.setMotors(world.motorFaults(), timeline, world.time());
    }
}
