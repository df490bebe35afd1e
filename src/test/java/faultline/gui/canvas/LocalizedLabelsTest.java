package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.paint.scene.SceneLabels;
import faultline.sensor.FaultKind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LocalizedLabelsTest {

    @AfterEach
    void restoreLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @ParameterizedTest
    @EnumSource(FaultKind.class)
    void everyKindOfFaultHasANameOnTheCanvas(FaultKind kind) {
        SceneLabels labels = LocalizedLabels.create();
        assertFalse(labels.faultName().apply(kind).isBlank());
        Messages.setLanguage(Language.POLISH);
        assertFalse(labels.faultName().apply(kind).isBlank());
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void aSensorThatIsOffHasAShortName(Language language) {
        Messages.setLanguage(language);
        assertEquals(
                language == Language.ENGLISH ? "off" : "milczy",
                LocalizedLabels.create().faultName().apply(FaultKind.OFF));
    }
}
