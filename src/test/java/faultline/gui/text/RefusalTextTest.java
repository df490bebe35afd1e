package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.world.Refusal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every refusal of the world has a text in both languages. */
class RefusalTextTest {

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @ParameterizedTest
    @EnumSource
    void everyReasonIsTranslated(Refusal.Reason reason) {
        Refusal refusal = new Refusal(reason, reason == Refusal.Reason.UNKNOWN_MOTOR_FAULT ? "left" : "sofa");
        assertEquals(refusal.message(), RefusalText.format(refusal), "the English texts are equal");
        Messages.setLanguage(Language.POLISH);
        assertNotEquals(refusal.message(), RefusalText.format(refusal));
    }

    @Test
    void idsAreNotTranslated() {
        Messages.setLanguage(Language.POLISH);
        assertEquals(
                "nie ma przeszkody none", RefusalText.format(new Refusal(Refusal.Reason.UNKNOWN_OBSTACLE, "none")));
    }
}
