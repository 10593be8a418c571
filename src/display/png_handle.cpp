#include "display/png_handle.h"

#include <cstring>

namespace emulsion {

namespace {

void remember(png_structp png, const char* message) noexcept {
    auto& text = static_cast<PngMessage*>(png_get_error_ptr(png))->text;
    if (text[0] == '\0') std::strncpy(text.data(), message, text.size() - 1);
}

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    remember(png, message);
    png_longjmp(png, 1);
}

void on_warning(png_structp png, png_const_charp message) { remember(png, message); }
void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

png_structp create(PngTask task, PngMessage& message) {
    return task == PngTask::read ? png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, ignore_warning)
                                 : png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
}

}  // namespace

PngHandle::PngHandle(PngTask task, PngMessage& message)
    : task_(task), png_(create(task, message)), info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {}

PngHandle::~PngHandle() {
    if (task_ == PngTask::read) {
        png_destroy_read_struct(&png_, &info_, nullptr);
    } else {
        png_destroy_write_struct(&png_, &info_);
    }
}

}  // namespace emulsion
