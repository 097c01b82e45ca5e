// Played: esp_lcd_panel_io.h has it all.
#pragma once
