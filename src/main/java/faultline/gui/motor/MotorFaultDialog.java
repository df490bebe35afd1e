package faultline.gui.motor;

import faultline.gui.edit.CommandSender;
import faultline.gui.form.FormDialog;
import faultline.gui.panel.FaultFields;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.world.Command;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridBagLayout;
import javax.swing.JPanel;

/** Asks for a fault of the motors of a side, and adds it to the run. */
public final class MotorFaultDialog {

    private final Component parent;
    private final CommandSender sender;
    /** The fault that was added last, which is offered next. */
    private MotorFault last = MotorFaultKind.WEAK.createFault(MotorFaultKind.WEAK.defaultValue());

    /** Creates a dialog above a component; the sender receives the faults. */
    public MotorFaultDialog(Component parent, CommandSender sender) {
        this.parent = parent;
        this.sender = sender;
    }

    /** Asks for a fault of a side, waits for the answer, and adds the fault unless the user cancels. */
    public void addFault(MotorSide side) {
        FaultFields<MotorFaultKind, MotorFault> fields = FaultFields.forMotors();
        fields.setFault(last.kind(), last.value(), 0);
        JPanel form = new JPanel(new GridBagLayout());
        fields.addWithDescription(form, 0);
        // Fields stay where they are when the dialog is higher than they need.
        JPanel content = new JPanel(new BorderLayout());
        content.add(form, BorderLayout.NORTH);
        String title = Messages.get("motors.fault", FaultText.motors(side));
        if (FormDialog.showDialog(
                parent, title, content, fields.kindField(), () -> FormDialog.findRefusedNumber(form))) {
            fields.commitFault().ifPresent(fault -> {
                last = fault;
                sender.send(new Command.InjectMotorFault(side, fault));
            });
        }
    }
}
