package faultline.gui.form;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.text.FaultText;
import faultline.sensor.FaultKind;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.plaf.basic.BasicComboBoxUI;
import javax.swing.plaf.basic.ComboPopup;
import org.junit.jupiter.api.Test;

class NamedChoiceTest {

    @Test
    void aLetterHighlightsAnEntryOfTheOpenListAndChoosesFromTheClosedOne() {
        AtomicBoolean open = new AtomicBoolean(true);
        List<FaultKind> chosen = new ArrayList<>();
        runOnEdt(() -> {
            NamedChoice<FaultKind> box = new NamedChoice<>(FaultKind.values(), FaultText::nameOf, chosen::add);
            box.setUI(new BasicComboBoxUI() {
                @Override
                public boolean isPopupVisible(JComboBox<?> any) {
                    return open.get();
                }
            });
            JList<?> list = ((ComboPopup) box.getUI().getAccessibleChild(box, 0)).getList();
            list.setSelectedIndex(0);
            box.selectWithKeyChar('d');
            assertEquals(FaultKind.DROPOUT, list.getSelectedValue());
            assertEquals(FaultKind.OFF, box.value());
            assertEquals(List.of(), chosen);
            box.selectWithKeyChar('d');
            assertEquals(FaultKind.DRIFT, list.getSelectedValue(), "the next one");
            open.set(false);
            box.selectWithKeyChar('d');
            assertEquals(List.of(FaultKind.DROPOUT), chosen);
        });
    }
}
