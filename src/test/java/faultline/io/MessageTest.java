package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class MessageTest {

    private enum SampleTemplate implements Message.Template {
        PLACE("{0} at {1}"),
        CORNER("the corner");

        private final String english;

        SampleTemplate(String english) {
            this.english = english;
        }

        @Override
        public String key() {
            return name();
        }

        @Override
        public String english() {
            return english;
        }
    }

    @Test
    void aMessageInAMessageIsTranslatedToo() {
        Message message = SampleTemplate.PLACE.with(4, SampleTemplate.CORNER.with());
        assertEquals("4 at the corner", message.toString());
        assertEquals("4 bei der Ecke", message.text(kind -> kind == SampleTemplate.PLACE ? "{0} bei {1}" : "der Ecke"));
    }
}
